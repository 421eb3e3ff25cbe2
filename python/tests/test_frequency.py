"""How creep forces follow oscillations."""

import numpy as np
import pytest
import wheelrail
from wheelrail import frequency

Y = np.linspace(-0.012, 0.012, 161)
STATE = {"radius": 0.46, "load": 6e4}
COARSE = {"normal_elements_along": 20, "normal_elements_across": 16}


def test_slow_oscillation_is_steady_and_fast_one_falls_and_lags():
    ratios = [0.02, 0.1, 0.3, 1.0]
    found = frequency.response(Y, Y**2, ratios, **STATE, **COARSE)
    ratio = found.ratio("fx")
    assert found.steady_fx < 0.0 and found.length == pytest.approx(0.011, rel=0.2)
    # It lags by the way over which it builds up, less than a length.
    assert abs(ratio[0] - 1.0) < 2.0 * np.pi * 0.02
    assert (np.diff(np.abs(ratio)) < 0.0).all()
    lag = np.degrees(np.angle(ratio))
    assert (lag < 0.0).all() and (np.diff(lag) < 0.0).all()
    # The force builds up over about half a contact: a lag of first order.
    assert -40.0 < lag[1] < -5.0


def test_finer_elements_and_steps_change_little():
    ratios = [0.1, 0.5, 1.5]
    coarse = frequency.response(Y, Y**2, ratios, oscillating="lateral", **STATE, **COARSE)
    fine = frequency.response(
        Y, Y**2, ratios, oscillating="lateral", samples=48, **STATE,
        normal_elements_along=36, normal_elements_across=20,
    )  # fmt: skip
    apart = coarse.ratio("fy") / fine.ratio("fy")
    assert (np.abs(np.abs(apart) - 1.0) < 0.03).all()
    assert (np.abs(np.degrees(np.angle(apart))) < 3.0).all()


CIRCLE = Y**2 / (2 * 0.46)
HEAVY = {"radius": 0.46, "load": 8e4}


def test_few_elements_err_as_the_theory_says_and_so_does_a_lag_of_first_order():
    ratios = [0.1, 0.2, 0.5]
    # Share of the length of a lag of first order, its errors up to L/lambda = 0.2 in amplitude and degrees.
    for oscillating, force, share, most in [
        ("longitudinal", "fx", 0.75, (0.032, 2.6)),
        ("lateral", "fy", 0.65, (0.043, 1.9)),
    ]:
        few, fine = (
            frequency.response(
                Y, CIRCLE, ratios, oscillating=oscillating, **HEAVY,
                normal_elements_along=elements, normal_elements_across=elements,
            )
            for elements in (8, 20)
        )  # fmt: skip
        steady = [getattr(found, f"steady_{force}") for found in (few, fine)]
        assert abs(steady[0] / steady[1] - 1.0) < 0.04
        apart = few.ratio(force) / fine.ratio(force)
        assert (np.abs(np.abs(apart) - 1.0) < 0.06).all(), apart
        assert (np.abs(np.degrees(np.angle(apart))) < 1.9).all(), apart
        lag = 1.0 / (1.0 + 2j * np.pi * share * np.array(ratios))
        apart = (lag / fine.ratio(force))[:2]
        assert (np.abs(np.abs(apart) - 1.0) < most[0]).all(), apart
        assert (np.abs(np.degrees(np.angle(apart))) < most[1]).all(), apart


def test_with_slip_a_load_makes_the_force_oscillate():
    found = frequency.response(
        Y, Y**2, [0.05, 0.5], oscillating="load", creepage_longitudinal=2e-3, **STATE, **COARSE
    )
    assert found.steady_fx < 0.0 and abs(found.ratio("fx")[1]) < abs(found.ratio("fx")[0]) < 1.1


def test_refusals_name_what_is_wrong():
    for given, message in [
        ({"length_over_wave": [0.1, 20.0]}, "length_over_wave = 20.0"),
        ({"length_over_wave": 0.1, "oscillating": "vertical"}, 'oscillating = "vertical"'),
        ({"length_over_wave": 0.1, "samples": 4}, "samples = 4"),
        ({"length_over_wave": 0.1, "amplitude": -1.0}, "amplitude = -1.0"),
    ]:
        ratios = given.pop("length_over_wave")
        with pytest.raises(wheelrail.BadValueError, match=message):
            frequency.response(Y, Y**2, ratios, **given, **STATE)
