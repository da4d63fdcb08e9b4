"""What is said where an address that a command is to listen at cannot be had: each of them, and what changes it."""

import socket
from pathlib import Path

import pytest

from app.cli.addresses import Wanted, demanded, simulated_at
from app.cli.plainly import CannotStart
from app.plant import read

PLANTS = Path(__file__).parents[2] / "plants"
FILE = Path("plants/mine.yaml")


def test_every_address_that_is_taken_is_named_with_whose_it_is_and_what_changes_it() -> None:
    with socket.create_server(("127.0.0.1", 0)) as one, socket.create_server(("127.0.0.1", 0)) as other:
        port, its = one.getsockname()[1], other.getsockname()[1]
        wanted = [
            Wanted("127.0.0.1", port, "--port"),
            Wanted("127.0.0.1", 0, "V001"),
            Wanted("127.0.0.1", its, "V002"),
        ]
        with pytest.raises(CannotStart) as refused:
            demanded(wanted, FILE)
    assert refused.value.message == (
        f"cannot listen at 127.0.0.1:{port} (--port), 127.0.0.1:{its} (V002): Address already in use"
    )
    assert refused.value.remedy == (
        "Choose another one with --port. "
        "Is it simulated already? End that, or write other addresses into plants/mine.yaml."
    )


def test_an_address_of_another_machine_is_told_from_one_that_is_taken() -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        wanted = [
            Wanted("192.0.2.1", 17001, "V001"),  # of the block that RFC 5737 keeps for documentation
            Wanted("127.0.0.1", taken.getsockname()[1], "--operator"),
        ]
        with pytest.raises(CannotStart) as refused:
            demanded(wanted, FILE)
    said = refused.value.message.split("; ")
    assert said[0].endswith("(--operator): Address already in use")
    assert said[1] == "cannot listen at 192.0.2.1:17001 (V001): Cannot assign requested address"
    assert refused.value.remedy is not None
    assert refused.value.remedy.startswith("Choose another one with --operator. Write addresses of this machine into")


def test_what_can_be_had_is_left_free_again() -> None:
    with socket.create_server(("127.0.0.1", 0)) as found:
        port = found.getsockname()[1]
    demanded([Wanted("127.0.0.1", port, "V001")], FILE)
    demanded([Wanted("127.0.0.1", port, "V001")], FILE)


def test_two_machines_at_one_address_are_said_where_one_host_is_given_for_all() -> None:
    with socket.create_server(("127.0.0.1", 0)) as found:
        port = found.getsockname()[1]
    with pytest.raises(CannotStart, match=r"\(V002\): Address already in use"):
        demanded([Wanted("127.0.0.1", port, "V001"), Wanted("127.0.0.1", port, "V002")], FILE)


def test_hoists_and_links_are_simulated_at_their_addresses_but_who_dials_in_listens_nowhere() -> None:
    text = (PLANTS / "demo.yaml").read_text(encoding="utf-8")
    plant, _ = read(text, "demo")
    assert [str(one) for one in simulated_at(plant)][-3:] == [
        "127.0.0.1:17010 (V010)",
        "127.0.0.1:17021 (hall)",
        "127.0.0.1:17031 (axes)",
    ]
    assert {one.host for one in simulated_at(plant, "0.0.0.0")} == {"0.0.0.0"}
    dialling, _ = read(
        text.replace('dev_id: 10, address: "127.0.0.1:17010"', "dev_id: 10, listen: true").replace(
            "name: demo", 'name: demo\nlisten: "127.0.0.1:17100"', 1
        ),
        "demo",
    )
    assert "V010" not in {one.by for one in simulated_at(dialling)}
