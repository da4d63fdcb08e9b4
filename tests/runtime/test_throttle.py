"""Log-in attempts, in virtual time."""

from app.runtime.throttle import FORGET, OF_ACCOUNT, OF_ADDRESS, ROOM, Throttle


def tries(throttle: Throttle, seconds: int, account: str = "kim", address: str = "10.0.0.1") -> int:
    """Return how many attempts are looked at if somebody tries ten times a second for so long."""
    return sum(throttle.begin(account, address, tick / 10) == 0.0 for tick in range(seconds * 10))


def test_a_few_failures_are_free_and_then_the_pause_doubles() -> None:
    throttle = Throttle()
    assert [throttle.begin("kim", "10.0.0.1", 0.0) for _ in range(6)] == [0.0] * 5 + [1.0]
    assert throttle.begin("kim", "10.0.0.1", 0.5) == 0.5
    assert throttle.begin("kim", "10.0.0.1", 1.0) == 0.0
    assert throttle.begin("kim", "10.0.0.1", 1.0) == 2.0
    assert throttle.begin("kim", "10.0.0.1", 3.0) == 0.0
    assert throttle.begin("kim", "10.0.0.1", 3.0) == 4.0


def test_an_account_is_tried_some_seventy_times_an_hour_and_never_kept_from_its_owner_for_more_than_a_minute() -> None:
    throttle = Throttle()
    assert 60 <= sum(throttle.begin("kim", f"10.0.{t % 250}.{t // 250 % 250}", t / 1) == 0.0 for t in range(3600)) <= 75
    assert throttle.begin("kim", "192.168.0.1", 3600.0) <= OF_ACCOUNT.longest


def test_an_address_that_tries_many_accounts_waits_too() -> None:
    throttle = Throttle()
    looked_at = sum(throttle.begin(f"user{n}", "10.0.0.1", 0.0) == 0.0 for n in range(100))
    assert looked_at == OF_ADDRESS.free
    assert throttle.begin("another", "10.0.0.2", 0.0) == 0.0


def test_letters_in_upper_case_are_no_other_account() -> None:
    throttle = Throttle()
    for n in range(5):
        throttle.begin("kim", f"10.0.0.{n}", 0.0)
    assert throttle.begin("KIM", "10.0.0.9", 0.0) > 0.0


def test_who_knows_the_password_begins_anew() -> None:
    throttle = Throttle()
    for _ in range(4):
        throttle.begin("kim", "10.0.0.1", 0.0)
    throttle.begin("kim", "10.0.0.1", 0.0)
    throttle.good("kim", "10.0.0.1")
    assert tries(throttle, 1) == 5


def test_an_address_is_not_forgiven_what_others_failed_there() -> None:
    throttle = Throttle()
    for n in range(19):
        throttle.begin(f"user{n}", "10.0.0.1", 0.0)
    throttle.begin("kim", "10.0.0.1", 0.0)
    throttle.good("kim", "10.0.0.1")
    assert throttle.begin("lee", "10.0.0.1", 0.0) == 0.0
    assert throttle.begin("park", "10.0.0.1", 0.0) > 0.0


def test_all_is_forgotten_an_hour_after_the_last_failure() -> None:
    throttle = Throttle()
    tries(throttle, 10)
    assert throttle.begin("kim", "10.0.0.1", 10.0 + FORGET) == 0.0
    assert [throttle.begin("kim", "10.0.0.1", 10.0 + FORGET) for _ in range(5)] == [0.0] * 4 + [1.0]


def test_a_flood_of_names_does_not_fill_the_memory() -> None:
    throttle = Throttle()
    for n in range(2 * ROOM):
        throttle.begin(f"user{n}", f"address{n}", 0.0)
    assert len(throttle._failed) <= ROOM
