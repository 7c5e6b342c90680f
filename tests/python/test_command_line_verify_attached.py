# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""`girdle verify` of a shoulder that another model includes, attaches or has saved."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from conftest import ABOVE_TOLERANCE, Girdle, Refuses

TREE = Path(__file__).resolve().parents[2] / "model" / "shoulder_tree" / "shoulder_right.xml"
FITTING = '<option integrator="implicitfast" timestep="0.002"/>'
REMARK = "Every failure is so small that it may come from rounding"


def attached(folder: Path, prefix: str, option: str = FITTING) -> Path:
    """A torso with the right shoulder, whose names get a prefix."""
    model = folder / "torso.xml"
    model.write_text(
        f"""<mujoco>
  {option}
  <asset><model name="shoulder" file="{TREE}"/></asset>
  <worldbody><body name="torso" pos="0 0 1">
    <geom type="sphere" size="0.1" contype="0" conaffinity="0"/>
    <attach model="shoulder" body="thorax" prefix="{prefix}"/>
  </body></worldbody>
</mujoco>
"""
    )
    return model


def rounded(text: str, attribute: str, digits: int) -> str:
    """The model with the numbers of an attribute rounded to some significant digits."""

    def shorter(found: re.Match[str]) -> str:
        numbers = " ".join(f"{float(number):.{digits}g}" for number in found[1].split())
        return f' {attribute}="{numbers}"'

    changed = re.sub(rf' {attribute}="([^"]*)"', shorter, text)
    assert changed != text
    return changed


def test_a_shoulder_attached_with_an_empty_prefix_is_verified(girdle_fine: Girdle, tmp_path: Path) -> None:
    assert "\nPASS: " in girdle_fine("verify", attached(tmp_path, "")).text


def test_a_prefix_is_named_with_what_to_do(refuses: Refuses, tmp_path: Path) -> None:
    because = ('It has "her_elevation_r": ', "with an empty prefix", "girdle verify --mapping")
    refuses("verify", attached(tmp_path, "her_"), because=because)


def test_options_that_the_shoulder_needs_are_named(refuses: Refuses, tmp_path: Path) -> None:
    model = attached(tmp_path, "", '<option timestep="0.002"/>')
    because = ("Attach conflict", 'Give your model the <option> .* integrator="implicitfast"')
    refuses("verify", model, because=because)


@pytest.mark.parametrize(("digits", "says"), [(6, True), (3, False)])
def test_a_model_that_fails_by_rounding_alone_says_so(
    girdle: Girdle, tmp_path: Path, digits: int, says: bool
) -> None:
    model = tmp_path / "saved.xml"
    model.write_text(rounded(TREE.read_text(), "quat", digits))
    report = girdle("verify", model)
    assert report.code == ABOVE_TOLERANCE
    assert (REMARK in report.text.replace("\n", " ")) == says, report.text
