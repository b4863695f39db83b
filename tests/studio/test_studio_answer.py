"""The bytes of an answer."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from wireprint.window.answer import ALIGNMENT, decoded, encoded

ARRAYS = st.sampled_from(["<f4", "<u4", "u1"]).flatmap(
    lambda kind: arrays.arrays(kind, arrays.array_shapes(max_dims=3, min_side=0, max_side=5))
)


@given(st.dictionaries(st.text(max_size=8), ARRAYS, max_size=4), st.text())
def test_an_answer_comes_back_as_it_was(given_arrays, text):
    answer = encoded({"text": text}, given_arrays)
    head, found = decoded(answer)
    assert head == {"text": text}
    assert set(found) == set(given_arrays)
    for name, array in given_arrays.items():
        assert found[name].dtype == array.dtype
        np.testing.assert_array_equal(found[name], array)


def test_arrays_lie_where_a_page_may_look_at_them():
    answer = encoded({"x": "y" * 3}, {"a": np.zeros(3, "u1"), "b": np.arange(5, dtype="<f4")})
    length = int.from_bytes(answer[:4], "little")
    assert (4 + length) % ALIGNMENT == 0
    head = answer[4 : 4 + length]
    assert b'"offset":8' in head
    assert len(answer) == 4 + length + 8 + 20


def test_what_json_cannot_say_is_a_fault():
    with pytest.raises(ValueError, match="JSON"):
        encoded({"x": float("nan")})
