"""The fast plant delivers what the byte-level one does, on the same fab with the same transfers."""

from app.plant.fab import SIZES, generate, populate
from app.sim.agreement import fast, orders, to_the_byte


def test_both_plants_deliver_alike() -> None:
    plant = populate(generate(SIZES["1k"], 1).plant, 8, 1, 0.5)
    work = orders(plant, 1)
    slow, quick = (run(plant, 1, work, 20, 600.0) for run in (to_the_byte, fast))
    assert len(slow.delivered) > 30
    assert abs(quick.per_hour(60.0, 600.0) / slow.per_hour(60.0, 600.0) - 1) < 0.07


def test_no_port_is_in_two_transfers_and_each_begins_where_its_carrier_is() -> None:
    plant = populate(generate(SIZES["1k"], 1).plant, 8, 1, 0.5)
    work = orders(plant, 1)
    at = {station: carrier for carrier, station in plant.carriers}
    ends = [end.id for order in work for end in (order.source, order.destination)]
    assert len(ends) == len(set(ends)) > 200
    assert all(at[order.source.id] == order.carrier and order.destination.id not in at for order in work)
