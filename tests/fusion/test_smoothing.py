import numpy as np

from placecat.fusion.delay import delay
from placecat.fusion.hmm import emission_matrix, forward_filter, likelihoods, transition_matrix
from placecat.fusion.smoothing import smooth

SETTINGS = {
    "n_classes": 2,
    "delay_step": 0.5,
    "evidence": "hard",
    "reliability": "hard",
    "transition_counts": 1.0,
    "emission_counts": 1.0,
}


def made():
    rng = np.random.default_rng(1)
    proba = rng.dirichlet([1, 1], 12)
    training = [np.array([0, 0, 0, 1, 1, 1, 1, 0], np.int16)]
    cv = rng.dirichlet([1, 1], 8)
    return proba, {"training_sequences": training, "training_proba": cv, "training_truth": training[0]}


def test_each_sequence_starts_anew():
    proba, training = made()
    both = smooth(proba, [slice(0, 5), slice(5, 12)], **training, **SETTINGS)
    alone = smooth(proba[5:], [slice(0, 7)], **training, **SETTINGS)
    np.testing.assert_array_equal(both["hmm"][5:], alone["hmm"])
    np.testing.assert_array_equal(both["delayed"][5:], alone["delayed"])


def test_is_the_filter_and_then_the_delay():
    proba, training = made()
    transition = transition_matrix(training["training_sequences"], 2, smoothing=1.0)
    emission = emission_matrix(training["training_truth"], training["training_proba"], 2)
    expected = forward_filter(likelihoods(proba, emission), transition)
    result = smooth(proba, [slice(0, 12)], **training, **SETTINGS)
    np.testing.assert_array_equal(result["hmm"], expected)
    np.testing.assert_array_equal(result["delayed"], delay(expected, step=0.5))
