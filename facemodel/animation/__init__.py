"""Animation: tracks, events, speech and idle life as frozen values, evaluated and edited by pure functions.

What a clip shows at a time is composed in this order (`facemodel.animation.evaluation`):

1. every captured curve, displaced by its layers, plus its track's keys;
2. events, 3. speech and 4. idle life, added on top: together they raise a weight no further than to full, or to where
   the keys or the largest of them alone had it;
5. while speech closes the lips, what opens them is held back;
6. each channel is clamped to its range.

Times are seconds.  Channels are named as displacement fields are (``12L``, ``26``), beside the rigid motions of head
and eyes (`facemodel.animation.channels`).
"""
