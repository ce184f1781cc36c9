"""Where the face is seen from, and what is drawn with it."""

from __future__ import annotations

from app.actions.action import Action
from app.view_state import VIEW_TITLES, ViewName

VIEW_KEYS: dict[ViewName, str] = {"front": "1", "three-quarter": "2", "left": "3", "right": "Ctrl+3", "top": "7"}

VIEW_HINTS: dict[ViewName, str] = {
    "front": "Look at the face from the front",
    "three-quarter": "Look at the face from the front and somewhat from its left",
    "left": "Look at the subject’s left side",
    "right": "Look at the subject’s right side",
    "top": "Look down on the head",
}


def _view(view: ViewName) -> Action:
    return Action(
        f"view.{view}",
        VIEW_TITLES[view],
        lambda context: context.view.look_from(view),
        menu=("View",),
        shortcut=VIEW_KEYS[view],
        hint=VIEW_HINTS[view],
        kind="choice",
        checked=lambda context: context.view.state.view == view,
    )


def _shown(member: str, title: str, shortcut: str, hint: str, group: int = 3) -> Action:
    return Action(
        f"view.{member}",
        title,
        lambda context: context.view.toggle(member),
        menu=("View",),
        group=group,
        shortcut=shortcut,
        hint=hint,
        kind="toggle",
        checked=lambda context: bool(getattr(context.view.state, member)),
        toolbar=group == 3,
    )


LOOKING_ACTIONS = (
    *(_view(view) for view in VIEW_TITLES),
    _shown("perspective", "Perspective", "5", "Near things look larger; off for a parallel projection", group=1),
    _shown("turntable", "Turntable", "T", "Turn the head slowly", group=1),
    Action(
        "view.head",
        "Whole head",
        lambda context: context.host.frame_head(),
        menu=("View",),
        group=2,
        shortcut="Home",
        hint="Bring the whole head into view",
    ),
    Action(
        "view.frame",
        "Frame selection",
        lambda context: context.host.frame_selection(),
        menu=("View",),
        group=2,
        shortcut="F",
        hint="Bring the selected muscle, or else the face, near",
    ),
    _shown("skull", "Skull", "K", "Draw the skull through the skin"),
    _shown("muscles", "Muscles", "U", "Draw the muscles, coloured by group"),
    _shown("forces", "Forces", "O", "Draw the forces of the active muscles as arrows"),
    _shown("supports", "Supports", "P", "Mark where the skin is held"),
    _shown("wireframe", "Wireframe", "W", "Draw the edges of the finite elements"),
    _shown("influence", "Influence", "I", "Colour the skin by how strongly the selected muscle pulls there"),
    _shown(
        "linear",
        "Pure linear sum",
        "",
        "Leave out what is not linear: the arc of the jaw, lids on the eyeball, lips on each other and on the teeth",
        group=4,
    ),
)
