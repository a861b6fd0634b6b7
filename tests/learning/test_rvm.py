import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.special import expit
from sklearn.gaussian_process import GaussianProcessClassifier
from sklearn.gaussian_process.kernels import RBF, ConstantKernel

from placecat.errors import PlacecatError
from placecat.learning.kernels import rbf_gram
from placecat.learning.rvm import RVM, _basis, _laplace_mode, _Surrogate


def ring(n=200, seed=0):
    rng = np.random.default_rng(seed)
    X = rng.uniform(-2, 2, (n, 2))
    return X, rng.random(n) < expit(5 * (1.3 - np.hypot(*X.T)))


def slow_evidence(basis, target, alpha):
    """Return the log evidence in the Laplace approximation, finding the mode with a general optimiser."""

    def loss(w):
        f = basis @ w
        return np.logaddexp(0, f).sum() - target @ f + 0.5 * (alpha * w) @ w

    w = minimize(loss, np.zeros(len(alpha)), tol=1e-12).x
    p = expit(basis @ w)
    hessian = basis.T @ (basis * (p * (1 - p))[:, None]) + np.diag(alpha)
    return -loss(w) + 0.5 * np.log(alpha).sum() - 0.5 * np.linalg.slogdet(hessian)[1]


def tipping_2001(basis, target, rounds=120):
    """Maximise the evidence over all functions at once: set alpha to gamma / w^2, and prune above 1e6."""
    alpha, kept = np.ones(basis.shape[1]), np.arange(basis.shape[1])
    w = np.zeros(basis.shape[1])
    for _ in range(rounds):
        phi = basis[:, kept]
        for _ in range(25):
            p = expit(phi @ w)
            hessian = phi.T @ (phi * (p * (1 - p))[:, None]) + np.diag(alpha)
            w = w + np.linalg.solve(hessian, phi.T @ (target - p) - alpha * w)
        alpha = np.maximum(1 - alpha * np.diag(np.linalg.inv(hessian)), 1e-12) / w**2
        alive = alpha < 1e6
        alpha, w, kept = alpha[alive], w[alive], kept[alive]
    return kept, alpha, w


def test_against_dense_evidence_maximisation():
    X, y = ring()
    gram = rbf_gram(X, 0.5)
    model = RVM(gamma=0.5, tol=1e-7).fit(X, y)
    basis = np.column_stack([gram.astype(float), np.ones(len(X))])
    kept, alpha, w = tipping_2001(basis, y.astype(float))
    assert model.evidence_ >= slow_evidence(basis[:, kept], y, alpha) - 0.1
    theirs = expit(basis[:, kept] @ w)
    # Both are local optima, so their predictions differ slightly.
    assert np.abs(model.predict_proba(X)[:, 1] - theirs).mean() < 0.04
    assert (model.predict(X) == (theirs > 0.5)).mean() > 0.95
    assert len(model.support_) <= 15


def test_evidence_follows_the_definition():
    X, y = ring()
    gram = rbf_gram(X, 0.5).astype(float)
    model = RVM(gamma=0.5).fit(X, y)
    basis, alpha = gram[:, model.support_], model.alpha_
    if model.intercept_ == 0.0:
        assert model.evidence_ == pytest.approx(slow_evidence(basis, y, alpha), abs=1e-3)
    mode = _laplace_mode(basis.T.copy(), y.astype(float), alpha, np.zeros(len(alpha)))
    assert mode.evidence == pytest.approx(slow_evidence(basis, y, alpha), abs=1e-3)


def test_rank_one_steps_have_the_stated_gain():
    """In the Gaussian problem, the gains add up to the difference between two directly computed evidences."""
    X, y = ring(60)
    gram = rbf_gram(X, 0.5)
    target, active = y.astype(float), np.array([3, 60])
    basis = _basis(gram, active)
    alpha = np.array([0.5, 2.0])
    mode = _laplace_mode(basis, target, alpha, np.zeros(2))
    surrogate = _Surrogate(gram, basis, mode, active, np.array([1, 10, 20, 30]))
    new_active, new_alpha, weights, gain = surrogate.ascend(alpha, 50)
    z = mode.weights @ basis + mode.error / mode.curvature

    def evidence(functions, precisions):
        phi = _basis(gram, functions)
        c = np.diag(1 / mode.curvature) + phi.T @ (phi / precisions[:, None])
        return -0.5 * (np.linalg.slogdet(c)[1] + z @ np.linalg.solve(c, z)), phi, c

    before, _, _ = evidence(active, alpha)
    after, phi, c = evidence(new_active, new_alpha)
    assert gain > 1.0
    assert after - before == pytest.approx(gain, rel=1e-3)
    np.testing.assert_allclose(weights, phi @ np.linalg.solve(c, z) / new_alpha, rtol=1e-2)


def test_agrees_with_a_gaussian_process():
    X, y = ring(300, seed=1)
    test, truth = ring(300, seed=2)
    gp = GaussianProcessClassifier(ConstantKernel(10.0) * RBF(1.0), optimizer=None).fit(X, y)
    ours = RVM(gamma=0.5).fit(X, y)
    assert (ours.predict(test) == gp.predict(test)).mean() > 0.93
    assert (ours.predict(test) == truth).mean() > (gp.predict(test) == truth).mean() - 0.03


def test_against_fastrvm():
    fastrvm = pytest.importorskip("fastrvm")
    X, y = ring()
    theirs = fastrvm.RVC(kernel="rbf", gamma=0.5, fit_intercept=True).fit(X, y.astype(int))
    ours = RVM(gamma=0.5, tol=1e-7).fit(X, y)
    np.testing.assert_allclose(ours.predict_proba(X)[:, 1], theirs.predict_proba(X)[:, 1], atol=0.02)
    assert (ours.predict(X) == (theirs.predict(X) == 1)).mean() > 0.97


def test_rows_equal_a_fit_on_these_rows_alone():
    X, y = ring()
    rows = np.arange(0, 200, 2)
    base = RVM(gamma=0.5)
    part = base.fit_rows(base.prepare(X.astype(np.float32)), y, rows)
    alone = RVM(gamma=0.5).fit(X[rows], y[rows])
    assert np.array_equal(part.support_, rows[alone.support_])
    np.testing.assert_allclose(part.dual_coef_, alone.dual_coef_, rtol=1e-3)


def test_fitting_twice_yields_identical_bytes():
    X, y = ring()
    first, second = RVM(gamma=0.5).fit(X, y), RVM(gamma=0.5).fit(X, y)
    assert first.dual_coef_.tobytes() == second.dual_coef_.tobytes()


def test_large_problem_path_finds_as_good_a_model(monkeypatch):
    from placecat.learning import rvm

    X, y = ring(400)
    full = RVM(gamma=2.0).fit(X, y)
    monkeypatch.setattr(rvm, "SHORTLIST", 50)
    short = RVM(gamma=2.0).fit(X, y)
    assert short.evidence_ > full.evidence_ - 2.0
    assert (short.predict(X) == full.predict(X)).mean() > 0.97


def test_separable_data():
    X = np.concatenate([np.zeros((20, 1)), np.ones((20, 1))])
    model = RVM(gamma=1.0).fit(X, np.repeat(["a", "b"], 20))
    assert model.predict([[0.1], [0.9]]).tolist() == ["a", "b"]


def test_random_labels_yield_finite_decisions():
    rng = np.random.default_rng(0)
    X, y = rng.normal(size=(100, 3)), np.arange(100) % 2 == 0
    model = RVM(gamma=1.0).fit(X, y)
    assert np.isfinite(model.decision_function(X)).all()


def test_messages():
    X, y = ring(20)
    with pytest.raises(PlacecatError, match=r"tol=0\.0: it must be greater than 0"):
        RVM(tol=0.0).fit(X, y)
    with pytest.raises(PlacecatError, match=r"max_iter=2\.5: it must be a valid integer"):
        RVM(max_iter=2.5).fit(X, y)
    RVM(gamma=np.float32(2.0), max_iter=np.int64(5)).fit(X, y)
    with pytest.raises(PlacecatError, match="needs samples of both classes"):
        RVM().fit_rows(rbf_gram(X, 1.0), np.zeros(20, bool))


def test_nearly_identical_frames():
    # Kernel values differ by less than float32 can resolve. This also happens in videos.
    rng = np.random.default_rng(2)
    places = rng.normal(size=(40, 3))
    X = np.repeat(places, 20, axis=0) + rng.normal(size=(800, 3)) * 1e-3
    y = np.repeat(np.sin(3 * places[:, 0]) + places[:, 1] > 0, 20)
    model = RVM(gamma=0.05).fit(X, y)
    assert np.isfinite(model.evidence_)
    assert model.evidence_ > RVM(gamma=0.05, max_iter=1).fit(X, y).evidence_
    assert (model.predict(X) == y).mean() > 0.8


def test_identical_functions_have_no_evidence():
    mode = _laplace_mode(np.ones((2, 4)), np.array([0.0, 0.0, 1.0, 1.0]), np.full(2, 1e-20), np.zeros(2))
    assert mode.evidence == -np.inf
