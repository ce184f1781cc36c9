"""What is chosen on the timeline, and how it lives through edits and undo."""

from dataclasses import replace

from hypothesis import given
from hypothesis import strategies as st

from app.document import Document
from app.timeline import deeds
from app.timeline.chosen import NOTHING, Chosen, all_of, carried, merged, reduced, times_of
from app.timeline.clipping import clipping, pasted
from app.timeline.moving import deleted, moved, on_other_side, scaled
from app.timeline.timeline import Timeline
from facemodel.animation.editing.selection import curve_of_row, rows
from tests.animation.strategies import animations

places = st.lists(st.integers(0, 5), unique=True).map(lambda each: tuple(sorted(each)))
selections = st.dictionaries(st.tuples(st.sampled_from(("12L", "17", "26")), st.integers(0, 1)), places)


def there(chosen: Chosen, animation) -> bool:
    """Whether everything that is chosen exists."""
    return (
        all(place < len(curve_of_row(animation, row)) for row, each in chosen.keys.items() for place in each)
        and chosen.events <= {event.key for event in animation.events}
        and all(place < len(animation.speech.phonemes) for place in chosen.sounds)
        and chosen.expressions <= {each.time for each in animation.expressions}
        and chosen.markers <= {each.time for each in animation.markers}
    )


def everything(animation) -> Chosen:
    return Chosen(
        all_of(animation),
        frozenset(event.key for event in animation.events),
        frozenset(range(len(animation.speech.phonemes))),
        frozenset(each.time for each in animation.expressions),
        frozenset(each.time for each in animation.markers),
        frozenset(each.name for each in animation.ranges),
    )


@given(selections, selections)
def test_what_is_taken_in_and_out_again_is_gone(one, other) -> None:
    both = merged(one, other)
    assert all(set(each) <= set(both[row]) for row, each in one.items() if each)
    left = reduced(both, other)
    assert all(not set(each) & set(other.get(row, ())) for row, each in left.items())
    assert Chosen(one).toggled(Chosen(one)).keys == {}


@given(animations(), animations())
def test_nothing_is_chosen_that_is_not_there(before, after) -> None:
    assert there(carried(everything(before), before, after), after)


@given(animations(), st.integers(-60, 60))
def test_what_is_moved_stays_chosen_and_undo_brings_it_back(animation, frames) -> None:
    chosen = everything(animation)
    made, now = moved(animation, chosen, frames / 30)
    assert there(now, made)
    assert now.key_count == chosen.key_count
    back, again = moved(made, now, -frames / 30)
    assert again.key_count == chosen.key_count
    for row in rows(animation):
        assert abs(curve_of_row(back, row).times - curve_of_row(animation, row).times).max(initial=0.0) < 1e-9


@given(animations(), st.floats(0.1, 4.0))
def test_what_is_scaled_keeps_its_order(animation, factor) -> None:
    made, now = scaled(animation, everything(animation), 1.0, factor)
    assert there(now, made)
    for row in rows(made):
        times = curve_of_row(made, row).times
        assert (times[1:] > times[:-1]).all()


@given(animations())
def test_what_is_deleted_is_gone_but_for_what_is_locked(animation) -> None:
    left = deleted(animation, everything(animation))
    assert not left.events
    assert not left.speech.phonemes
    assert not left.markers
    assert not left.ranges
    assert all(track.locked or not len(track.curve) for track in left.tracks)


@given(animations())
def test_a_mirror_twice_is_no_mirror(animation) -> None:
    chosen = Chosen(events=frozenset(event.key for event in animation.events))
    once, now = on_other_side(animation, chosen)
    twice, _ = on_other_side(once, now)
    assert [set(each.channels) for each in twice.events] == [set(each.channels) for each in animation.events]
    assert [each.amplitude for each in twice.events] == [each.amplitude for each in animation.events]


@given(animations())
def test_what_is_pasted_is_as_far_apart_as_it_was(animation) -> None:
    free = replace(animation, tracks=tuple(replace(track, locked=False) for track in animation.tracks))
    chosen = replace(everything(free), sounds=frozenset(), markers=frozenset(), ranges=frozenset())
    clip = clipping(free, chosen)
    begin = times_of(free, chosen)
    if begin is None or not clip:
        return
    made, now = pasted(free, clip, begin[0] + 1000.0)
    assert there(now, made)
    assert len(now.events) == len(free.events)
    reach = times_of(made, now)
    assert reach is not None
    assert abs((reach[1] - reach[0]) - (begin[1] - begin[0])) < 1e-6


def test_a_choice_survives_what_happens_beside_it(timeline: Timeline) -> None:
    timeline.choose(Chosen({("12L", 0): (2,)}))
    timeline.playhead.go(0.7)
    deeds.mark(timeline)
    timeline.choose(Chosen({("12L", 0): (2,)}))
    animation = timeline.animation
    timeline.edit(deleted(animation, Chosen({("12L", 0): (0,)})), "Delete")
    assert timeline.chosen.keys == {("12L", 0): (1,)}
    timeline.document.undo()
    assert timeline.chosen.keys == {("12L", 0): (2,)}


def test_another_project_has_nothing_chosen(timeline: Timeline, document: Document, project) -> None:
    timeline.choose(everything(timeline.animation))
    document.restore(project, None)
    assert timeline.chosen == NOTHING


def test_the_clipboard_goes_from_one_row_to_the_chosen_tracks(timeline: Timeline) -> None:
    timeline.choose(Chosen({("12L", 0): (0, 1)}))
    deeds.copy(timeline)
    timeline.change(lines=frozenset(("track 17", "track 12R")))
    timeline.playhead.go(3.0)
    deeds.paste(timeline)
    for channel in ("17", "12R"):
        assert curve_of_row(timeline.animation, (channel, 0)).times[-2:].tolist() == [3.0, 3.5]
    assert set(timeline.chosen.keys) == {("17", 0), ("12R", 0)}
