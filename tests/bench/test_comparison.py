from placecat_bench.comparison import Comparison, Limit, Peer

PEER = Peer("NumPy: sort", "numpy")


def comparison(**target):
    return Comparison("Sorting", "ten numbers", PEER, lambda: None, lambda: None, **target)


def test_speed_up_is_their_time_divided_by_ours():
    one = comparison(faster=3)
    assert one.ratio(2.0, 8.0) == 4.0
    assert (one.is_met(3.0), one.is_met(2.99)) == (True, False)
    assert one.target == "at least 3x faster"


def test_at_most_limits_our_time_divided_by_theirs():
    one = comparison(at_most=4.5)
    assert one.ratio(8.0, 2.0) == 4.0
    assert (one.is_met(4.5), one.is_met(4.51)) == (True, False)
    assert one.target == "at most 4.5x its time"


def test_a_limit_is_an_upper_or_a_lower_bound():
    above = Limit("Sorting", "", "numbers/s", lambda: 1.0, at_least=40)
    below = Limit("Sorting", "", "difference", lambda: 1.0, at_most=0)
    assert (above.is_met(40), above.is_met(39.9), above.target) == (True, False, "at least 40")
    assert (below.is_met(0), below.is_met(1e-9), below.target) == (True, False, "at most 0")


def test_nan_reaches_no_target():
    assert not comparison(faster=3).is_met(float("nan"))
    assert not Limit("Sorting", "", "difference", lambda: 1.0, at_most=0).is_met(float("nan"))
