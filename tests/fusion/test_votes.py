import numpy as np

from placecat.fusion.votes import vote_decision, vote_distribution

# One frame with three cues and two places. Two cues slightly favour the first place, and one strongly favours
# the second.
PROBA = np.array([[[0.6, 0.4], [0.55, 0.45], [0.05, 0.95]]])


def test_vote_distribution_averages_the_distributions():
    np.testing.assert_allclose(vote_distribution(PROBA), [[1.2 / 3, 1.8 / 3]])


def test_decisions_are_weighted_by_their_probability():
    np.testing.assert_allclose(vote_decision(PROBA), [[1.15 / 2.1, 0.95 / 2.1]])


def test_the_votes_can_differ():
    assert vote_distribution(PROBA).argmax() != vote_decision(PROBA).argmax()
