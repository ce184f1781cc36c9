"""Where the skull lies, in numbers: moved, turned and scaled; snapped to the depths of the tissue, and put back."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtWidgets import QCheckBox, QVBoxLayout, QWidget

from app.actions.context import Context
from app.authoring.skull import with_pose
from app.tools.tool import Bench
from facemodel.face import AT_REST, Pose, Triple
from facemodel.skull.placement import FARTHEST, LARGEST, SMALLEST, checked
from ui.panels.skull.deeds import RESET_HINT, SNAP_HINT, change, reset, snap
from ui.panels.skull.triple_row import TripleRow
from ui.panels.tissue.choices import Buttons
from ui.theme.metrics import GRID
from ui.widgets.number_scale import NumberScale

SHIFT = NumberScale(-FARTHEST, FARTHEST, 0.0, "mm")
TURN = NumberScale(-180.0, 180.0, 0.0, "°")
SCALE = NumberScale(100 * SMALLEST, 100 * LARGEST, 100.0, "%")
SLOW = {"shift": 20.0, "turn": 12.0, "scale": 24.0}
"""Times a bar's width that a hand drags through its whole range: a millimetre in five pixels or so."""

LABELS = {"shift": "Move skull", "turn": "Turn skull", "scale": "Scale skull"}
TIPS = {
    "shift": "Millimetres that the skull was moved: x to the subject's left, y up, z forward",
    "turn": "Degrees that the skull was turned about its own middle",
    "scale": "Size of the skull along its own axes; 100 % is as it was made",
}


class PlaceBox(QWidget):
    """Binds the pose of the skull to nine numbers, both ways; the bone follows the hand, and one drag is one step."""

    def __init__(self, context: Context, bench: Bench) -> None:
        super().__init__()
        self._context, self._bench = context, bench
        self._pose: Pose | None = None
        self.rows = {
            "shift": TripleRow("Move", SHIFT, SLOW["shift"], TIPS["shift"]),
            "turn": TripleRow("Turn", TURN, SLOW["turn"], TIPS["turn"]),
            "scale": TripleRow("Scale", SCALE, SLOW["scale"], TIPS["scale"]),
        }
        self.follow = QCheckBox("Muscles go along with the bone")
        self.follow.setToolTip("Origins keep their place on the bone when it moves; else they stay where they are")
        self.scales = QCheckBox("Snapping may scale")
        self.scales.setToolTip("Let snapping change the size of the skull along its axes, too")
        self.scales.setChecked(True)
        self.buttons = Buttons(
            (
                ("Snap to depths", SNAP_HINT, lambda: snap(context, bench, self.scales.isChecked())),
                ("Reset", RESET_HINT, lambda: reset(context)),
            ),
            2,
        )
        layout = QVBoxLayout(self)
        layout.setContentsMargins(GRID, 0, GRID, 0)
        layout.setSpacing(GRID // 2)
        for widget in (*self.rows.values(), self.follow, self.scales, self.buttons):
            layout.addWidget(widget)
        self._connect()
        self._show()

    def _connect(self) -> None:
        view, document = self._context.view, self._context.document
        for kind, row in self.rows.items():
            row.previewed.connect(lambda axis, value, kind=kind: self._preview(kind, axis, value))
            row.committed.connect(lambda kind=kind: self._keep(LABELS[kind]))
            row.cancelled.connect(self._let_go)
        self.follow.toggled.connect(lambda on: view.change(origins_follow=on))
        view.changed.connect(self._show)
        document.project_changed.connect(self._show)
        document.skull_changed.connect(self._show)
        self._bench.sight.pose_changed.connect(self._show_pose)
        snapping = self._bench.snapping
        snapping.changed.connect(lambda on: self.buttons.by_name["Snap to depths"].setEnabled(not on))
        snapping.failed.connect(self._context.host.show_error)

    def _show(self, *_now: object) -> None:
        self._show_pose(self._pose)
        self.follow.blockSignals(True)
        self.follow.setChecked(self._context.view.state.origins_follow)
        self.follow.blockSignals(False)

    def _show_pose(self, pose: Pose | None) -> None:
        """The numbers of a pose in the hand, or of the one that the project has."""
        project = self._context.document.project
        shown = pose or project.face.skull.placement.pose
        self.rows["shift"].show_values(shown.shift)
        self.rows["turn"].show_values(shown.turn)
        self.rows["scale"].show_values(tuple(100 * factor for factor in shown.scale))
        self.buttons.by_name["Reset"].setEnabled(project.face.skull.placement.pose != AT_REST)

    def _preview(self, kind: str, axis: int, value: float) -> None:
        """The bone goes along with the number."""
        pose = self._pose or self._context.document.project.face.skull.placement.pose
        numbers = list(getattr(pose, kind))
        numbers[axis] = value / 100 if kind == "scale" else value
        made: Triple = (numbers[0], numbers[1], numbers[2])
        self._pose = checked(replace(pose, **{kind: made}))
        self._bench.sight.pose_changed.emit(self._pose)

    def _keep(self, label: str) -> None:
        pose, self._pose = self._pose, None
        if pose is not None:
            origins = self._context.view.state.origins_follow
            change(self._context, lambda project: with_pose(project, pose, origins), label)
        self._bench.sight.pose_changed.emit(None)

    def _let_go(self) -> None:
        self._pose = None
        self._bench.sight.pose_changed.emit(None)
