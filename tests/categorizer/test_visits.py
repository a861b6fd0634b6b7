from placecat.categorizer.visits import Visit, VisitLog

STEPS = [
    ("kitchen", 0.5, 0.0),
    ("kitchen", 0.7, 1.0),
    ("unknown", 0.2, 3.0),
    ("kitchen", 0.9, 3.5),
    ("kitchen", 0.9, 3.5),
    ("kitchen", 0.6, 6.0),
]


def test_stays_are_runs_of_one_name_and_follow_each_other():
    log = VisitLog()
    assert log.until(1.0) == []
    for name, confidence, seconds in STEPS:
        log.add(name, confidence, seconds)
    assert log.until(8.0) == [
        Visit("kitchen", 0.0, 3.0, 0.6, 2),
        Visit("unknown", 3.0, 3.5, 0.2, 1),
        Visit("kitchen", 3.5, 8.0, 0.8, 3),
    ]


def test_listed_visits_do_not_change():
    log = VisitLog()
    log.add("kitchen", 0.5, 0.0)
    first = log.until(1.0)
    log.add("bedroom", 0.5, 1.0)
    assert first == [Visit("kitchen", 0.0, 1.0, 0.5, 1)]
    assert [visit.end for visit in log.until(2.0)] == [1.0, 2.0]
