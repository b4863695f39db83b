"""The rules of a printable file, judged by brute force: every move against every strand.

It shares no code with `wireprint.check` and follows the words of ARCHITECTURE, "The certificate".
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from brute_head import Head, far_apart, hits
from brute_machine import Machine, Move
from brute_strands import ROUNDING_MM, Strands, contacts, distances, laid

if TYPE_CHECKING:
    from wireprint import Settings


@dataclass
class Verdict:
    """Lines that break each rule, and those that graze it."""

    found: dict[str, set[int]] = field(default_factory=dict)
    grazes: dict[str, set[int]] = field(default_factory=dict)

    def add(self, rule: str, line: int) -> None:
        """Note a breach."""
        self.found.setdefault(rule, set()).add(line)


class Judge:
    """Judges one text by the rules that a profile gives."""

    def __init__(self, lines: list[str], settings: Settings, rules: dict[str, Any]) -> None:
        """Carry out the text."""
        self.rules, self.strand_mm = rules, rules["strand_mm"]
        self.run = Machine(settings, rules).carry_out(lines)
        self.moves: list[Move] = self.run.moves
        self.strands: Strands = laid(self.moves, self.run.dwells)
        self.out = coming_out(self.moves, rules["limits"]["pulled_back_mm"])
        self.verdict = Verdict()

    def judge(self) -> Verdict:
        """Hold the text against every rule."""
        self.verdict.found["cold"] = set(self.run.cold)
        self.verdict.found["unhomed"] = set(self.run.unhomed)
        self.collisions()
        self.bounds()
        bed_mm = self.rules["bed_contact_mm"]
        held = [
            contacts(self.strands, i, self.strand_mm, bed_mm) for i in range(len(self.strands.move))
        ]
        for chain in self.chains():
            Walk(self, chain, held).go()
            self.feed(chain, held)
        return self.verdict

    def line(self, strand: int) -> int:
        """Line of a strand."""
        return self.moves[self.strands.move[strand]].line

    def chains(self) -> list[range]:
        """Strands of each chain."""
        numbers, found, first = self.strands.chain, [], 0
        for index in range(1, len(numbers) + 1):
            if index == len(numbers) or numbers[index] != numbers[first]:
                found.append(range(first, index))
                first = index
        return found

    def collisions(self) -> None:
        """Every move against every strand before it, its own at its end, and the bed."""
        head, ends = Head.of(self.rules["head"]), self.strands.ends
        paths, others, lines = [], [], []
        for index, move in enumerate(self.moves):
            path = np.array([move.start, move.end])
            if move.end[2] < -1e-9:
                self.verdict.add("collisions", move.line)
            before = ends[: self.strands.before[index]]
            near = before[~far_apart(head, path, before)]
            paths += [path] * len(near)
            others += list(near)
            lines += [move.line] * len(near)
            if index in self.owned:
                paths.append(path[[1, 1]])
                others.append(ends[self.owned[index]])
                lines.append(move.line)
        for part in range(0, len(lines), 20_000):
            cut = slice(part, part + 20_000)
            certain, possible = hits(
                head, np.array(paths[cut]), np.array(others[cut]), self.strand_mm / 2
            )
            told = np.array(lines[cut])
            self.verdict.found.setdefault("collisions", set()).update(map(int, told[certain]))
            self.verdict.grazes.setdefault("collisions", set()).update(map(int, told[possible]))

    @property
    def owned(self) -> dict[int, int]:
        """The strand that each move lays."""
        return {move: strand for strand, move in enumerate(self.strands.move)}

    def bounds(self) -> None:
        """The build volume, and what machine and firmware allow."""
        limits = self.rules["limits"]
        for move in self.moves:
            if move.homing:
                continue
            length = math.dist(move.start, move.end)
            speed = min(move.speed, limits["feed_mm_s"])
            flow = move.filament * limits["filament_area_mm2"] * speed / length if length else 0.0
            in_place = abs(move.filament) if length == 0 else 0.0
            if (
                (length > 0 and self.outside(move) > 1e-6)
                or (length > 0 and move.speed > limits["feed_mm_s"] * 1.005)
                or flow > limits["flow_mm3_s"] * 1.005
                or in_place > limits["filament_only_mm"] * 1.005
            ):
                self.verdict.add("out_of_bounds", move.line)

    def outside(self, move: Move) -> float:
        """How far a move ends outside of what it may reach, mm."""
        bed = self.rules["bed"]
        x, y = (at - middle for at, middle in zip(move.end, bed["centre_mm"], strict=False))
        half_x, half_y = bed["half_mm"]
        over = move.end[2] - bed["height_mm"]
        lies = max(move.start[2], move.end[2]) <= self.rules["bed_contact_mm"]
        (low_x, low_y), (high_x, high_y) = bed["margins_mm"]
        if (move.filament <= 0 or lies) and any((low_x, low_y, high_x, high_y)):
            sides = (-half_x - low_x - x, x - half_x - high_x, -half_y - low_y - y)
            return max(*sides, y - half_y - high_y, over)
        if bed["round"]:
            return max(math.hypot(x, y) - half_x, over)
        return max(abs(x) - half_x, abs(y) - half_y, over)

    def feed(self, chain: range, held: list[list[tuple[float, float]]]) -> None:
        """Enough filament for a strand: in pieces of a diameter at least."""
        per_mm = math.pi / 4 * self.strand_mm**2 / self.rules["limits"]["filament_area_mm2"]
        first, length, hanging, filament, top, running = chain[0], 0.0, 0.0, 0.0, 0.0, False
        for strand in chain:
            long = self.strands.length[strand]
            length += long
            hanging += (1 - sum(b - a for a, b in held[strand])) * long
            filament += self.out[self.strands.move[strand]]
            top = max(top, *self.strands.ends[strand][:, 2])
            if length < self.strand_mm and strand != chain[-1]:
                continue
            lying = 0.05 if top <= self.rules["bed_contact_mm"] else 0.015
            least = 0.25 if hanging > self.strand_mm else lying
            low = filament / (length * per_mm) < least
            if low and not running:
                self.verdict.add("underfed", self.line(first))
            running = low
            first, length, hanging, filament, top = strand + 1, 0.0, 0.0, 0.0, 0.0

    def settled(self, strand: int) -> bool:
        """Whether the head dwells at a strand's end for long enough."""
        least, dwell = self.rules["settling"]["dwell_s"], self.strands.dwell[strand]
        return dwell is not None and dwell > 0 and dwell >= least

    def hurried(self, strand: int) -> None:
        """Note it if the head leaves a free end too soon."""
        settling, move = self.rules["settling"], self.strands.move[strand]
        slow = self.moves[move].speed <= settling["slow_mm_s"]
        if self.settled(strand) or slow or self.overshoots(move) or settling["dwell_s"] <= 0:
            return
        self.verdict.add("hurried", self.line(strand))

    def overshoots(self, move: int) -> bool:
        """Whether the head goes straight up from a move's end, and comes back."""
        if move + 2 >= len(self.moves):
            return False
        end, (up, back) = self.moves[move].end, self.moves[move + 1 : move + 3]
        straight = up.start == end and up.end[:2] == end[:2] and up.filament <= 0
        return straight and up.end[2] - end[2] >= self.strand_mm / 2 and back.end == end


class Walk:
    """Goes along a chain: what holds it, and how far it hangs between."""

    def __init__(self, judge: Judge, chain: range, held: list[list[tuple[float, float]]]) -> None:
        """Begin at the chain's start."""
        self.judge, self.chain, self.held = judge, chain, held
        self.ends = judge.strands.ends
        self.support_z = self.ends[chain[0]][0][2]
        self.hanging = self.standing = self.held_at = 0.0
        self.rising = True

    def go(self) -> None:
        """Walk to the chain's end."""
        judge, first = self.judge, self.chain[0]
        if not self.held[first] or self.held[first][0][0] > 1e-9:
            judge.verdict.add("floating_starts", judge.line(first))
        touching = False
        for strand in self.chain:
            touching = self.along(strand)
        last = self.chain[-1]
        if touching:
            return
        closed = self.closes(last)
        self.stretch(last, free=not closed)
        if closed:
            return
        later = self.ends[last + 1 :]
        near = len(later) and distances(self.ends[last][1], later).min()
        if len(later) and near <= judge.strand_mm + ROUNDING_MM:
            judge.hurried(last)
        else:
            judge.verdict.add("dangling_ends", judge.line(last))

    def along(self, strand: int) -> bool:
        """Go along one strand; return whether it ends in contact."""
        judge = self.judge
        start, end = self.ends[strand]
        long = judge.strands.length[strand]
        falls = end[2] <= start[2]
        if self.rising and falls:
            self.rising = False
            if self.hanging > 0 and start[2] - self.support_z >= judge.strand_mm / 2:
                judge.hurried(strand - 1)
                self.stand(strand - 1)
        done = 0.0
        for a, b in self.held[strand]:
            self.hanging += (a - done) * long
            self.stretch(strand, free=False)
            self.support_z = start[2] + b * (end[2] - start[2])
            self.standing, self.rising = 0.0, True
            self.held_at = judge.strands.arc[strand] + b * long
            done = b
        touching = done >= 1 - 1e-9
        self.hanging += 0.0 if touching else (1 - done) * long
        if touching:
            return True
        self.rising &= not falls
        within = self.standing + self.hanging <= judge.rules["free_end_limit_mm"]
        if judge.settled(strand) and within:
            self.stand(strand)
        return False

    def stand(self, strand: int) -> None:
        """What hangs up to a strand's end carries itself from here on."""
        strands = self.judge.strands
        self.standing += self.hanging
        self.stretch(strand, free=True)
        self.support_z = self.ends[strand][1][2]
        self.held_at = strands.arc[strand] + strands.length[strand]
        self.rising = False

    def stretch(self, strand: int, *, free: bool) -> None:
        """End a stretch that hangs."""
        limit = self.judge.rules["free_end_limit_mm" if free else "span_limit_mm"]
        line = self.judge.line(strand)
        if self.hanging > limit + 1e-6:
            self.judge.verdict.add("spans_over", line)
        elif self.hanging > limit - 1e-6:
            self.judge.verdict.grazes.setdefault("spans_over", set()).add(line)
        self.hanging = 0.0

    def closes(self, last: int) -> bool:
        """Whether the chain ends on itself, close behind: in a loop, or at a held corner."""
        strands, diameter = self.judge.strands, self.judge.strand_mm
        end = self.ends[last][1]
        whole = strands.arc[last] + strands.length[last]
        counted = strands.arc[last] - 3 * diameter
        swept = np.zeros(3)
        for strand in reversed(self.chain):
            start, to = self.ends[strand]
            near = first_within(start, to, end, diameter / 2)
            if near is not None:
                arc = strands.arc[strand] + near * strands.length[strand]
                back = whole - arc
                place = start + near * (to - start)
                area = np.linalg.norm(swept + np.cross(to - end, place - end)) / 2
                if back >= diameter and (arc <= self.held_at or area >= 0.02 * back**2):
                    return True
            swept += np.cross(to - end, start - end)
            if strands.arc[strand] < counted:
                break
        return False


def first_within(start: Any, to: Any, point: Any, radius: float) -> float | None:
    """Share of a segment at which it first comes within a radius of a point; None: nowhere."""
    run, off = to - start, start - point
    a, b, c = run @ run, off @ run, off @ off - radius**2
    root = b * b - a * c
    if a == 0 or root < 0:
        return None
    low, high = (-b - math.sqrt(root)) / a, (-b + math.sqrt(root)) / a
    return None if high < 0 or low > 1 else max(low, 0.0)


def coming_out(moves: list[Move], slack_mm: float) -> list[float]:
    """Filament that leaves the nozzle in each move, mm; what was pulled back must come first."""
    out, debt = [], 0.0
    for move in moves:
        owed = debt if debt > slack_mm or move.start == move.end else 0.0
        out.append(max(move.filament - owed, 0.0) if move.filament > 0 else move.filament)
        debt = max(debt - move.filament, 0.0)
    return out
