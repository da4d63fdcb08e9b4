"""Pieces of playback: kept in order, found by time, bounded by age and size."""

from app.store.playback import CHANGES, STATE, Piece, PlaybackReader, PlaybackStore


def piece(kind: str, begin: float, size: int = 10) -> Piece:
    return Piece(kind, begin, begin + 2, 1, b"x" * size)


def test_pieces_are_found_by_time_and_id(url: str) -> None:
    store = PlaybackStore(url)
    reader = PlaybackReader(url)
    assert (reader.span().begin, reader.state_before(5.0)) == (None, None)
    store.append([piece(STATE, 0), piece(CHANGES, 0), piece(CHANGES, 10), piece(STATE, 20), piece(CHANGES, 20)])
    span = reader.span()
    assert (span.begin, span.end, span.size) == (0, 22, 50)
    before, later = reader.state_before(19.9), reader.state_before(20.0)
    assert before is not None
    assert later is not None
    assert (before.begin, later.begin) == (0, 20)
    assert [found.begin for found in reader.changes(2, 20)] == [0, 10, 20]
    assert [found.begin for found in reader.changes(2.5, 19)] == [10]
    assert [found.begin for found in reader.changes(0, 30, later.id)] == [20]
    reader.close()
    store.close()


def test_what_is_old_or_too_much_goes_the_oldest_first(url: str) -> None:
    store = PlaybackStore(url)
    store.append([piece(CHANGES, float(n), 100) for n in range(10)])
    assert store.prune(4.0, 10_000) == 2
    assert store.prune(0.0, 350) == 5
    store.close()
    again = PlaybackStore(url)
    assert again.prune(0.0, 300) == 0
    assert again.prune(0.0, 0) == 3
    reader = PlaybackReader(url)
    assert reader.changes(0, 100) == []
    reader.close()
    again.close()
