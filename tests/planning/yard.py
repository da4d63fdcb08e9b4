"""Vehicles on random one-way networks, almost full, that drive by what the real Traffic grants and by nothing else."""

from collections import deque
from itertools import pairwise
from random import Random

from app.domain.ids import VehicleId
from app.domain.layout import Edge, Plant, Point
from app.domain.units import Barcode, Millimetres
from app.planning.blocking import Blocked
from app.planning.buffers import Buffers
from app.planning.track import Track
from app.planning.traffic import Traffic
from app.sim.rules import Network

EDGES = (Millimetres(1500), Millimetres(600))
"""A vehicle is 1 m long: each barcode is a place to wait, or every other one."""
DWELL, CHANGE = 0.2, 0.1


def track_of(seed: int, pitch: int) -> Track:
    """Return a track with the connections of a random network of ``app.sim.rules``, and chains of two to four slots."""
    rng, outs = Random(f"{seed}/yard"), Network(seed).outs
    chains = [[Barcode(f"{i}-{k}") for k in range(pitch * rng.randint(2, 4))] for i in range(len(outs))]
    edges = [Edge(a, b, EDGES[pitch - 1]) for chain in chains for a, b in pairwise(chain)]
    edges += [Edge(chains[i][-1], chains[j][0], EDGES[pitch - 1]) for i, of_one in enumerate(outs) for j in of_one]
    points = tuple(Point(b, Millimetres(0), Millimetres(0)) for chain in chains for b in chain)
    return Track(Plant(f"yard {seed}", points, tuple(edges), (), ()))


class Yard:
    """One such network: all but one to three of its places are taken."""

    def __init__(self, seed: int, *, admission: bool, pitch: int = 1) -> None:
        self.rng = Random(f"{seed}/drivers")
        self.track = track_of(seed, pitch)
        self.pitch = pitch
        self.buffers = Buffers(self.track, Millimetres(1000))
        self.traffic = Traffic(self.track, admission=admission)
        self.at: dict[VehicleId, Barcode] = {}
        self.way: dict[VehicleId, list[Barcode]] = {}
        self.moves = 0
        self._fill()

    def _fill(self) -> None:
        places = [deque(chain[::-1][:: self.pitch]) for chain in self.buffers.chains]
        count = sum(map(len, places)) - self.rng.randint(1, 3)
        for number in range(max(1, count)):
            vehicle = VehicleId(f"V{number:02}")
            for chain in self.rng.sample(places, len(places)):
                if not chain:
                    continue
                way = self.way_from(chain[0])
                if self.traffic.claim(vehicle, [chain[0]], goal_included=not way, beyond=way).granted:
                    self.at[vehicle], self.way[vehicle] = chain.popleft(), way
                    break
            else:
                self.traffic.forget(vehicle)

    def way_from(self, start: Barcode) -> list[Barcode]:
        """Return the way with the fewest barcodes to some other place."""
        goal = self.rng.choice([b for b in self.track.barcodes if b != start])
        before: dict[Barcode, Barcode] = {}
        queue = deque([start])
        while goal not in before:
            here = queue.popleft()
            for after in self.track.successors(here):
                if after not in before:
                    before[after] = here
                    queue.append(after)
        way = [goal]
        while before[way[-1]] != start:
            way.append(before[way[-1]])
        return way[::-1]

    def drive(self, vehicle: VehicleId, most: int = 4) -> Blocked | None:
        """Claim some barcodes, go as far as is granted, and give back the rest."""
        way = self.way[vehicle]
        wanted = way[: self.rng.randint(1, most)]
        beyond = way[len(wanted) :]
        grant = self.traffic.claim(vehicle, wanted, not beyond, beyond=beyond)
        if grant.granted:
            left = [b for b in self.traffic.held(vehicle) if b != grant.granted[-1]]
            self.at[vehicle] = grant.granted[-1]
            del way[: len(grant.granted)]
            self.traffic.release(vehicle, left)
            self.moves += 1
        return grant.blocked

    def change_mind(self, vehicle: VehicleId) -> None:
        """A waiting vehicle wants to go elsewhere, if that closes no circle; else it keeps to its way."""
        before, self.way[vehicle] = self.way[vehicle], self.way_from(self.at[vehicle])
        way = self.way[vehicle]
        self.traffic.claim(vehicle, (), goal_included=False, beyond=way)
        if self.traffic.strays(vehicle, way):
            self.way[vehicle] = before
            self.traffic.claim(vehicle, (), goal_included=False, beyond=before)

    def run(self, rounds: int) -> bool:
        """Let everyone go on, in random order, so many times; return whether they locked up."""
        for _ in range(rounds):
            order = self.rng.sample(sorted(self.at), len(self.at))
            moves, dwelling = self.moves, False
            for vehicle in order:
                if not self.way[vehicle]:
                    dwelling = True
                    if self.rng.random() < DWELL:
                        self.way[vehicle] = self.way_from(self.at[vehicle])
                elif self.drive(vehicle) is not None and self.rng.random() < CHANGE:
                    self.change_mind(vehicle)
            if self.moves == moves and not dwelling and self._locked():
                return True
        return False

    def _locked(self) -> bool:
        """Whether nobody can go on, asked once more one after the other without a change of mind."""
        moves = self.moves
        for vehicle in sorted(self.at):
            self.drive(vehicle)
        return self.moves == moves
