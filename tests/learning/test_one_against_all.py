import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sklearn.base import clone
from sklearn.calibration import CalibratedClassifierCV
from sklearn.linear_model import LogisticRegression
from sklearn.multiclass import OneVsRestClassifier
from sklearn.naive_bayes import GaussianNB
from sklearn.svm import NuSVC

from number_of_examples import examples
from placecat.errors import PlacecatError
from placecat.learning.calibration import make_folds
from placecat.learning.gentle_adaboost import GentleAdaBoost
from placecat.learning.nu_svm import NuSVM
from placecat.learning.one_against_all import OneAgainstAll
from placecat.learning.rvm import RVM

BASES = [NuSVM(gamma=0.5, nu=0.2), RVM(gamma=0.5), GentleAdaBoost(n_rounds=10)]


def homes(n=150, classes=3, homes=3, seed=0, spread=1.0):
    rng = np.random.default_rng(seed)
    y = np.arange(n) % classes
    X = 2.0 * np.eye(classes)[y] + spread * rng.normal(size=(n, classes))
    return X.astype(np.float32), y, np.arange(n) * homes // n


@pytest.mark.parametrize("calibration", ["samples", "consecutive", "homes_averaged"])
def test_outputs_equal_calibrated_nusvc(calibration):
    X, y, groups = homes(240)
    ours = OneAgainstAll(NuSVM(gamma=0.5, nu=0.3, tol=1e-5), calibration).fit(X, y, groups=groups)
    folds = make_folds(y, groups, calibration, 5)
    ensemble = calibration == "homes_averaged"
    assert len(folds) == (3 if ensemble else 5)
    svm = NuSVC(gamma=0.5, nu=0.3, tol=1e-5)
    theirs = OneVsRestClassifier(CalibratedClassifierCV(svm, method="sigmoid", ensemble=ensemble, cv=folds))
    theirs.fit(X.astype(float), y)
    test = np.random.default_rng(5).normal(size=(50, 3))
    expected = np.stack([e.predict_proba(test)[:, 1] for e in theirs.estimators_], axis=1)
    np.testing.assert_allclose(ours.outputs(test), expected, atol=1e-3)


@pytest.mark.parametrize("exclusive", [True, False])
@pytest.mark.parametrize("named_prior", ["training", "uniform"])
def test_scheme_against_a_naive_transcription(exclusive, named_prior):
    X, y, groups = homes()
    keep = (y < 2) | (np.arange(len(y)) % 2 == 0)
    X, y, groups = X[keep], y[keep], groups[keep]
    model = OneAgainstAll(
        BASES[0], uncertainty=0.3, reliability_smoothing=0.0, exclusive=exclusive, prior=named_prior
    )
    model.fit(X, y, groups=groups)
    prior = [np.mean(y == i) for i in range(3)] if named_prior == "training" else [1 / 3] * 3
    answers = model.cv_outputs_
    if exclusive:
        answers = np.array([row / sum(row) for row in answers])
    reliability = [[answers[y == i, k].mean() for k in range(3)] for i in range(3)]
    p_o = [sum(reliability[i][k] * prior[i] for i in range(3)) for k in range(3)]
    for outputs, answer, proba in zip(
        model.cv_outputs_, answers, model.combine(model.cv_outputs_), strict=True
    ):
        beta = 0.3 * (1 / max(outputs) - 1)
        p = [
            sum(reliability[i][k] * prior[i] / p_o[k] * answer[k] for k in range(3)) + beta / 3
            for i in range(3)
        ]
        np.testing.assert_allclose(proba, np.array(p) / sum(p), atol=1e-12)


def test_weak_classifiers_do_not_always_choose_the_frequent_class():
    """With weak outputs, the literal variant always names the same class, but the default does not."""
    rng = np.random.default_rng(0)
    y = np.repeat([0, 0, 0, 1, 2], 60)
    X, test = (rng.normal(size=(300, 3)) + np.eye(3)[y] for _ in range(2))
    literal = OneAgainstAll(BASES[0], exclusive=False, prior="training", reliability="soft")
    literal = literal.fit(X, y).predict(test)
    default = OneAgainstAll(BASES[0]).fit(X, y).predict(test)
    assert len(np.unique(literal)) == 1
    assert len(np.unique(default)) == 3
    assert np.mean([(default[y == k] == k).mean() for k in range(3)]) > 0.4


def test_hard_reliability_counts_decisions():
    X, y, groups = homes()
    model = OneAgainstAll(BASES[0], reliability="hard", exclusive=False).fit(X, y, groups=groups)
    for i in range(3):
        for k in range(3):
            yes = int((model.cv_outputs_[y == i, k] >= 0.5).sum())
            assert model.reliability_[i, k] == pytest.approx((yes + 1) / (50 + 2))
    exclusive = OneAgainstAll(BASES[0], reliability="hard").fit(X, y, groups=groups)
    decided = exclusive.cv_outputs_.argmax(axis=1)
    counts = [[((y == i) & (decided == k)).sum() + 1 for k in range(3)] for i in range(3)]
    np.testing.assert_allclose(exclusive.reliability_, np.array(counts) / 53)


def test_perfect_reliabilities_return_the_outputs():
    model = OneAgainstAll()
    model.posterior_ = np.eye(3)
    np.testing.assert_allclose(model.combine(np.array([[0.2, 0.1, 0.1]])), [[0.5, 0.25, 0.25]])
    model.combination = "certainty"
    np.testing.assert_allclose(
        model.combine(np.array([[0.0, 0.0, 0.0], [0.3, 0.0, 0.1]]))[1], [0.75, 0.0, 0.25]
    )


def test_uncertainty_flattens_unsure_distributions():
    model = OneAgainstAll(uncertainty=1.0, exclusive=False)
    model.posterior_ = np.eye(2)
    # At a certainty of 50%, the additional mass is gamma = 1, and each of the two classes receives half of
    # it.
    np.testing.assert_allclose(model.combine(np.array([[0.5, 0.0]])), [[1.0 / 1.5, 0.5 / 1.5]])
    np.testing.assert_allclose(model.combine(np.array([[1.0, 0.0]])), [[1.0, 0.0]])
    np.testing.assert_allclose(model.combine(np.array([[1e-9, 0.0]])), [[0.5, 0.5]], atol=1e-8)
    np.testing.assert_allclose(model.combine(np.array([[0.0, 0.0]])), [[0.5, 0.5]])


@pytest.mark.parametrize("base", BASES, ids=lambda base: type(base).__name__)
def test_all_bases_learn_and_do_not_depend_on_threads(base):
    X, y, groups = homes(240)
    one = OneAgainstAll(base, n_jobs=1).fit(X, y, groups=groups)
    three = OneAgainstAll(base, n_jobs=3).fit(X, y, groups=groups)
    for name in ("sigmoid_", "machine_class_", "flat_", "nu_", "cv_outputs_", "reliability_", "prior_"):
        assert getattr(one, name).tobytes() == getattr(three, name).tobytes(), name
    assert one.predict_proba(X).tobytes() == three.predict_proba(X).tobytes()
    assert (one.combine(one.cv_outputs_).argmax(axis=1) == y).mean() > 0.8
    assert (one.predict(X) == y).mean() > 0.85
    assert (np.diag(one.reliability_) > 0.6).all()


@settings(max_examples=examples(15), deadline=None)
@given(
    seed=st.integers(0, 99),
    reliability=st.sampled_from(["hard", "soft"]),
    prior=st.sampled_from(["training", "uniform"]),
    uncertainty=st.sampled_from([0.0, 0.5]),
    spread=st.sampled_from([0.3, 4.0]),
)
def test_rows_sum_to_one(seed, reliability, prior, uncertainty, spread):
    X, y, groups = homes(60, seed=seed, spread=spread)
    model = OneAgainstAll(BASES[0], reliability=reliability, prior=prior, uncertainty=uncertainty)
    model.fit(X, y, groups=groups)
    for proba in (model.predict_proba(X), model.combine(model.cv_outputs_)):
        assert (proba >= 0).all()
        np.testing.assert_allclose(proba.sum(axis=1), 1.0)


@settings(max_examples=examples(6), deadline=None)
@given(permutation=st.permutations([0, 1, 2]), calibration=st.sampled_from(["consecutive", "homes_centred"]))
def test_renamed_classes_permute_the_columns(permutation, calibration):
    X, y, groups = homes(90)
    plain = OneAgainstAll(BASES[0], calibration).fit(X, y, groups=groups)
    renamed = OneAgainstAll(BASES[0], calibration).fit(X, np.array(permutation)[y], groups=groups)
    np.testing.assert_allclose(
        renamed.predict_proba(X)[:, permutation], plain.predict_proba(X), rtol=1e-9, atol=1e-12
    )
    np.testing.assert_allclose(renamed.cv_outputs_[:, permutation], plain.cv_outputs_, rtol=1e-9, atol=1e-12)


def test_nu_is_lowered_per_class_and_fold():
    X, y, groups = homes(200)
    y = np.where((y == 2) & (np.arange(200) % 4 > 0), 1, y)
    model = OneAgainstAll(NuSVM(gamma=0.5, nu=0.6), "homes_centred").fit(X, y, groups=groups)
    for k in range(3):
        rare = min((y == k).sum(), (y != k).sum())
        assert model.nu_[k] == pytest.approx(min(0.6, 2 * rare / 200))
        for g, nu in enumerate(model.fold_nu_[k]):
            rest = y[groups != g] == k
            assert nu == pytest.approx(min(0.6, 2 * min(rest.sum(), (~rest).sum()) / len(rest)))


def test_any_scikit_learn_classifier_can_be_the_base():
    X, y, groups = homes()
    for base in (LogisticRegression(), GaussianNB()):
        model = OneAgainstAll(base).fit(X, y, groups=groups)
        assert (model.predict(X) == y).mean() > 0.8


def test_sigmoid_settings():
    X, y, groups = homes()
    own = OneAgainstAll(RVM(gamma=0.5), sigmoid="own").fit(X, y, groups=groups)
    assert own.sigmoid_.tolist() == [[-1.0, 0.0]] * 3
    boosted = OneAgainstAll(GentleAdaBoost(5)).fit(X, y, groups=groups)
    assert boosted.sigmoid_.tolist() == [[-2.0, 0.0]] * 3
    platt = OneAgainstAll(GentleAdaBoost(5), sigmoid="platt").fit(X, y, groups=groups)
    assert platt.sigmoid_.tolist() != boosted.sigmoid_.tolist()
    balanced = OneAgainstAll(BASES[0], sigmoid_weights="balanced").fit(X, y, groups=groups)
    plain = OneAgainstAll(BASES[0]).fit(X, y, groups=groups)
    assert balanced.cv_outputs_.mean() > plain.cv_outputs_.mean()


def test_clone_keeps_parameters():
    model = OneAgainstAll(NuSVM(nu=0.1), uncertainty=0.2)
    assert clone(model).get_params()["base__nu"] == 0.1
    assert clone(model).uncertainty == 0.2


X3, Y3, _ = homes(30)


@pytest.mark.parametrize(
    ("model", "y", "message"),
    [
        (OneAgainstAll(), np.ones(30), "all training samples belong to one class, '1.0'"),
        (OneAgainstAll(), np.arange(30) == 3, "class 'True' has 1 training sample"),
        (OneAgainstAll(), Y3[:5], r"y has shape \(5,\) for 30 samples"),
        (
            OneAgainstAll(NuSVM(nu=0.9, nu_policy="refuse")),
            Y3,
            r"nu = 0.9 is infeasible for class '0' .*largest feasible value is 0.666667",
        ),
        (OneAgainstAll(NuSVM(nu=2.0)), Y3, "nu=2.0: it must be less than or equal to 1"),
        (OneAgainstAll(sigmoid="own"), Y3, "sigmoid 'own' needs a base classifier with its own sigmoid"),
        (OneAgainstAll(sigmoid="x"), Y3, "sigmoid=x: it must be '"),
        (OneAgainstAll(calibration="x"), Y3, "calibration=x: it must be '"),
        (OneAgainstAll(calibration="homes_centred"), Y3, "'homes_centred' needs the home of each sample"),
        (OneAgainstAll(reliability="x"), Y3, "reliability=x: it must be '"),
        (OneAgainstAll(prior="x"), Y3, "prior=x: it must be '"),
        (OneAgainstAll(combination="x"), Y3, "combination=x: it must be '"),
        (OneAgainstAll(sigmoid_weights="x"), Y3, "sigmoid_weights=x: it must be '"),
        (OneAgainstAll(folds=1), Y3, "folds=1: it must be greater than or equal to 2"),
        (OneAgainstAll(uncertainty=-1.0), Y3, "uncertainty=-1.0: it must be greater than or equal to 0"),
    ],
)
def test_messages(model, y, message):
    with pytest.raises(PlacecatError, match=message):
        model.fit(X3, y)


def test_messages_name_the_class():
    with pytest.raises(PlacecatError, match="infeasible for class 'bedroom'"):
        OneAgainstAll(NuSVM(nu=0.9, nu_policy="refuse")).fit(X3, Y3, class_names=["bedroom", "bath", "hall"])
