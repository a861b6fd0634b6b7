from types import SimpleNamespace

from placecat.vision.networks.efficientnet_lite import _one_thread


def test_one_thread_is_set_where_pytorch_says_so_already():
    # MKL has its own thread count, so it may use more threads.
    calls: list[int] = []
    with _one_thread(SimpleNamespace(get_num_threads=lambda: 1, set_num_threads=calls.append)):
        assert calls == [1]
    with _one_thread(SimpleNamespace(get_num_threads=lambda: 4, set_num_threads=calls.append)):
        assert calls == [1, 1, 1]
    assert calls == [1, 1, 1, 4]
