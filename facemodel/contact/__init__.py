"""What skin does where it meets something: lids on the eyeball and on each other, lips on each other and on the teeth.

A sum of fields knows nothing of that.  Every module here is computed once for a face as it is drawn, and then moves the
few posed points that it has to, in place.
"""
