"""The set of names that tells at once which orders are new."""

from app.store.names import Names


def test_a_name_that_was_added_is_never_called_new() -> None:
    names = Names(room=100)
    names.add_all(f"A{n}" for n in range(90))
    for n in range(1000):
        names.add(f"B{n}")
    assert not any(names.surely_not(f"A{n}") for n in range(90))
    assert not any(names.surely_not(f"B{n}") for n in range(1000))


def test_nearly_every_other_name_is_called_new_however_many_there_are() -> None:
    names = Names(room=100)
    for n in range(5000):
        names.add(f"B{n}")
    assert sum(names.surely_not(f"C{n}") for n in range(1000)) > 900


def test_names_added_one_by_one_and_at_once_are_the_same_set() -> None:
    one_by_one, at_once = Names(room=50), Names(room=50)
    words = [f"LOT-{n}" for n in range(50)]
    at_once.add_all(words)
    for word in words:
        one_by_one.add(word)
    others = [f"X{n}" for n in range(20_000)]
    assert [one_by_one.surely_not(word) for word in others] == [at_once.surely_not(word) for word in others]
