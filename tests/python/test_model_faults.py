# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""What the plugin says, when a model is loaded, of what MuJoCo changed in it without a word."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import TYPE_CHECKING

import mujoco
import pytest

pytestmark = pytest.mark.usefixtures("engine_with_plugin")

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

MODELS = Path(__file__).resolve().parents[2] / "model"
VERSION = tuple(int(part) for part in mujoco.__version__.split("."))
TREE = MODELS / "shoulder_tree" / "shoulder_right.xml"
LOOP = MODELS / "shoulder_loop" / "shoulder_right.xml"
SHIPPED = sorted(path for path in MODELS.glob("*/shoulder_*.xml") if not path.stem.endswith("_position"))

RADIAN = '<compiler angle="radian"/>'
OPTION = '<option timestep="{step_s:g}" integrator="implicitfast"/>'


@pytest.fixture
def warnings() -> Iterator[list[str]]:
    heard: list[str] = []
    mujoco.set_mju_user_warning(heard.append)
    yield heard
    mujoco.set_mju_user_warning(None)


def model_with(source: Path, change: Callable[[str], str], tmp_path: Path) -> mujoco.MjModel:
    path = tmp_path / "changed.xml"
    text = source.read_text()
    changed = change(text)
    assert changed != text
    path.write_text(changed)
    return mujoco.MjModel.from_xml_path(str(path))


def unguarded(source: Path, tmp_path: Path, put_into: tuple[str, str] = ("<mujoco", "<mujoco")) -> Path:
    """A model whose defaults leave a parent's as they are, as of earlier versions."""
    path = tmp_path / "unguarded.xml"
    text, count = re.subn(r'<(joint type="hinge" pos="0 0 0"|general) [^>]*/>', "", source.read_text())
    assert count == 2
    assert put_into[0] in text
    path.write_text(text.replace(*put_into))
    return path


def parent_of(source: Path, before: str, after: str, tmp_path: Path) -> mujoco.MjModel:
    path = tmp_path / "parent.xml"
    path.write_text(f'<mujoco>{before}<include file="{source}"/>{after}</mujoco>')
    return mujoco.MjModel.from_xml_path(str(path))


def said_of(model: mujoco.MjModel, warnings: list[str]) -> str:
    """What is said when data are made; nothing, or one warning."""
    warnings.clear()
    mujoco.MjData(model)
    assert len(warnings) <= 1, warnings
    return warnings[0] if warnings else ""


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: f"{path.parent.name}/{path.stem}")
def test_nothing_is_said_of_a_shipped_model(path: Path, warnings: list[str]) -> None:
    assert said_of(mujoco.MjModel.from_xml_path(str(path)), warnings) == ""
    assert len(SHIPPED) == 9


def test_ranges_that_were_read_as_degrees(tmp_path: Path, warnings: list[str]) -> None:
    model = parent_of(TREE, "", '<compiler angle="degree"/>', tmp_path)
    assert f"read as degrees: write {RADIAN} after the last <include>" in said_of(model, warnings)
    mended = parent_of(TREE, "", '<compiler angle="degree"/>' + RADIAN, tmp_path)
    assert said_of(mended, warnings) == ""


KINDS = {"tree": (TREE, 0.010, 0.002), "loop": (LOOP, 0.005, 0.001)}


@pytest.mark.parametrize(("kind", "path", "longest_s", "longest_rk4_s"), [(k, *v) for k, v in KINDS.items()])
@pytest.mark.parametrize("integrator", ["EULER", "RK4", "IMPLICIT", "IMPLICITFAST"])
def test_time_steps_longer_than_the_longest(
    kind: str, path: Path, longest_s: float, longest_rk4_s: float, integrator: str, warnings: list[str]
) -> None:
    model = mujoco.MjModel.from_xml_path(str(path))
    model.opt.integrator = getattr(mujoco.mjtIntegrator, "mjINT_" + integrator)
    longest = longest_rk4_s if integrator == "RK4" else longest_s
    model.opt.timestep = longest
    assert said_of(model, warnings) == ""
    for step_s in (longest + 0.001, 0.02):
        model.opt.timestep = step_s
        said = said_of(model, warnings)
        with_rk4 = " with RK4" if integrator == "RK4" else ""
        option = OPTION.format(step_s=min(step_s, longest_s))
        assert f"the longest for a {kind}{with_rk4} is {longest} s: write {option}" in said


@pytest.mark.parametrize(("kind", "path"), [("tree", TREE), ("loop", LOOP)])
def test_euler_that_takes_the_damping_explicitly(kind: str, path: Path, warnings: list[str]) -> None:
    model = mujoco.MjModel.from_xml_path(str(path))
    model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_EULERDAMP)
    assert said_of(model, warnings) == ""  # it is Euler's flag alone
    model.opt.integrator = mujoco.mjtIntegrator.mjINT_EULER
    option = OPTION.format(step_s=0.002)
    assert f"the longest for a {kind} with Euler without eulerdamp is 0.001 s: write {option}" in said_of(
        model, warnings
    )
    model.opt.timestep = 0.001
    assert said_of(model, warnings) == ""


def test_a_loop_that_nothing_closes(warnings: list[str]) -> None:
    model = mujoco.MjModel.from_xml_path(str(LOOP))
    model.eq_active0[0] = 0
    assert 'its <connect> starts inactive: write active="true" there' in said_of(model, warnings)
    model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_EQUALITY)
    assert 'equalities are disabled: write <flag equality="enable"/> in <option>' in said_of(model, warnings)
    model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONSTRAINT)
    said = said_of(model, warnings)
    assert 'constraints are disabled: write <flag constraint="enable"/> in <option>' in said
    tree = mujoco.MjModel.from_xml_path(str(TREE))
    tree.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_EQUALITY)
    assert said_of(tree, warnings) == ""


CONNECT = re.compile(r'<connect name="AC_r" (.*?)/>')


@pytest.mark.parametrize(
    ("equalities", "said"),
    [
        (r'<connect active="false" \1/><connect \1/>', ""),
        (r'<connect active="false" \1/>', 'its <connect> starts inactive: write active="true" there'),
        ("", 'no <connect> of two sites joins clavicle and scapula: write <connect site1="..." site2='),
    ],
    ids=["one of two is active", "inactive", "none"],
)
def test_what_joins_the_bones_of_a_loop(
    equalities: str, said: str, tmp_path: Path, warnings: list[str]
) -> None:
    model = model_with(LOOP, lambda text: CONNECT.sub(equalities, text), tmp_path)
    assert (said in said_of(model, warnings)) if said else said_of(model, warnings) == ""


@pytest.mark.parametrize("path", [TREE, LOOP], ids=["tree", "loop"])
@pytest.mark.parametrize(
    ("defaults", "line", "put_into"),
    [
        (
            '<joint actuatorfrcrange="-10 10"/>',
            'actuatorfrclimited="false" into <joint> of <default class="girdle">',
            ('<site pos="0 0 0" q', '<joint actuatorfrclimited="false"/><site q'),
        ),
        (
            '<general forcerange="-10 10"/>',
            'forcelimited="false" into each of the shoulder\'s <plugin> in <actuator>',
            ('instance="rhythm_r" ctrlrange', 'instance="rhythm_r" forcelimited="false" ctrlrange'),
        ),
    ],
    ids=["of joints", "of actuators"],
)
def test_force_ranges_of_a_parents_defaults(
    path: Path, defaults: str, line: str, put_into: tuple[str, str], tmp_path: Path, warnings: list[str]
) -> None:
    def with_defaults(source: Path, given: str) -> str:
        return said_of(parent_of(source, f"<default>{given}</default>", "", tmp_path), warnings)

    assert (
        'joint "sc_protraction_r" gets no more than -10 to 10 N m of its servo, which needs 150 where it '
        f"lags by 0.1 rad: write {line}" in with_defaults(unguarded(path, tmp_path), defaults)
    )
    # A servo is not held back by what it does not ask for.
    assert with_defaults(unguarded(path, tmp_path), defaults.replace("10", "160")) == ""
    assert with_defaults(unguarded(path, tmp_path, put_into), defaults) == ""


def test_a_disabled_damper(warnings: list[str]) -> None:
    model = mujoco.MjModel.from_xml_path(str(TREE))
    flags = mujoco.mjtDisableBit
    has_damper = hasattr(flags, "mjDSBL_DAMPER")  # before 3.3.6 one flag with springs
    model.opt.disableflags |= int(flags.mjDSBL_DAMPER if has_damper else flags.mjDSBL_PASSIVE)
    said = said_of(model, warnings)
    assert 'damping, which the servos need, is disabled: write <flag damper="enable"/>' in said


@pytest.mark.parametrize("path", [TREE, LOOP], ids=["tree", "loop"])
@pytest.mark.parametrize(
    ("inherited", "what", "line"),
    [
        ('stiffness="10"', "stiffness", 'stiffness="0"'),
        ('frictionloss="2"', "frictionloss", 'frictionloss="0"'),
        ('stiffness="10" frictionloss="2"', "stiffness and frictionloss", 'stiffness="0" frictionloss="0"'),
    ],
)
def test_what_a_parents_defaults_give_the_joints(
    path: Path, inherited: str, what: str, line: str, tmp_path: Path, warnings: list[str]
) -> None:
    defaults = f"<default><joint {inherited}/></default>"
    model = parent_of(unguarded(path, tmp_path), defaults, "", tmp_path)
    said = said_of(model, warnings)
    assert f'joint "sc_protraction_r" has {what}, which' in said
    assert f'write {line} into <joint> of <default class="girdle">' in said
    mended = unguarded(path, tmp_path, ('<site pos="0 0 0" q', f"<joint {line}/><site q"))
    assert said_of(parent_of(mended, defaults, "", tmp_path), warnings) == ""


@pytest.mark.skipif(VERSION < (3, 7), reason="damping is linear")
def test_nonlinear_damping_of_a_parents_defaults(tmp_path: Path, warnings: list[str]) -> None:
    model = parent_of(TREE, '<default><joint damping="1 2 3"/></default>', "", tmp_path)
    said = said_of(model, warnings)
    assert "has nonlinear damping, which" in said
    line = 'damping="0 0 0" '
    assert f'write {line}into <joint> of <default class="girdle">' in said
    mended = tmp_path / "mended.xml"
    mended.write_text(TREE.read_text().replace("<joint ", f"<joint {line}", 1))
    model = parent_of(mended, '<default><joint damping="1 2 3"/></default>', "", tmp_path)
    assert said_of(model, warnings) == ""


def test_a_joint_without_damping(warnings: list[str]) -> None:
    model = mujoco.MjModel.from_xml_path(str(TREE))
    model.dof_damping[model.joint("gh_axial_r").dofadr[0]] = 0
    said = said_of(model, warnings)
    assert 'joint "gh_axial_r" has damping 0 at a stiffness kp of 500: write damping="10"' in said


@pytest.mark.parametrize("path", [TREE, LOOP], ids=["tree", "loop"])
@pytest.mark.parametrize("side", ["_r", "_l"])
def test_ligaments_that_a_longer_clavicle_stretches(path: Path, side: str, warnings: list[str]) -> None:
    source = path if side == "_r" else path.with_name("shoulder_left.xml")
    model = mujoco.MjModel.from_xml_path(str(source))
    end = model.site("PAC" + side).pos.copy()
    if path is TREE:
        model.body("scapula" + side).pos[:] = 1.1 * end
    model.site("PAC" + side).pos[:] = 1.1 * end
    said = said_of(model, warnings)
    stated = dict(
        re.findall(r'tendon "(\w+)" is slack up to [\d.]+ m, .*?write springlength="0 ([\d.]+)"', said)
    )
    assert set(stated) == {"conoid" + side, "trapezoid" + side}
    for name, length in stated.items():
        slack_m = model.tendon_lengthspring[model.tendon(name).id]
        assert float(length) > slack_m[1]
        slack_m[1] = float(length)
    assert said_of(model, warnings) == ""
    # Nothing pulls any more: the arm is where it is told to be.
    data = mujoco.MjData(model)
    data.actuator("elevation" + side).ctrl[0] = math.radians(90)
    mujoco.mj_step(model, data, 1500)
    errors_rad = data.sensor("rhythm" + side).data[15:24]
    assert math.degrees(abs(errors_rad).max()) < 0.01


def test_several_faults_are_one_warning(warnings: list[str]) -> None:
    model = mujoco.MjModel.from_xml_path(str(TREE))
    model.opt.timestep = 0.02
    model.jnt_stiffness[:] = 1
    said = said_of(model, warnings)
    assert OPTION.format(step_s=0.01) + "; joint" in said
    assert said.startswith('girdle.rhythm instance "rhythm_r": ')


@pytest.mark.skipif(VERSION < (3, 4), reason="the bindings delete in another way")
def test_the_instance_of_a_deleted_shoulder_is_to_be_deleted_too(warnings: list[str]) -> None:
    spec = mujoco.MjSpec.from_file(str(TREE.with_name("shoulder_both.xml")))
    spec.delete(spec.body("clavicle_l"))
    with pytest.raises(ValueError, match="init failed") as refused:
        spec.compile()
    assert "it has lost its actuators" in "".join([str(refused.value), *warnings])
    for element in [*spec.plugins, *spec.sensors]:
        if element.name == "rhythm_l":
            spec.delete(element)
    assert spec.compile().nu == 12


@pytest.mark.skipif(not hasattr(mujoco.mjtEnableBit, "mjENBL_SLEEP"), reason="nothing sleeps")
def test_sleeping_that_is_switched_on_after_data_are_made(warnings: list[str]) -> None:
    model = mujoco.MjModel.from_xml_path(str(TREE))
    data = mujoco.MjData(model)
    model.opt.enableflags |= int(mujoco.mjtEnableBit.mjENBL_SLEEP)
    warnings.clear()
    mujoco.mj_step(model, data, 10)
    assert len(warnings) == 1
    assert "sleeping was switched on after mj_makeData: call mj_resetData" in warnings[0]
    warnings.clear()
    mujoco.mj_resetData(model, data)
    data.ctrl[0] = 1
    mujoco.mj_step(model, data, 1500)
    assert warnings == []
    assert data.sensor("rhythm_r").data[3] == pytest.approx(1, abs=1e-6)
