"""A hunt: a part with a mistake, which the seed of the person's workbook chooses."""

import hashlib
import re
import secrets

SEED = re.compile(r"^\s*// seed (\d+)\s*$")


def new_seed():
    """Of four digits, so that a person can say it."""
    return secrets.randbelow(9000) + 1000


def seed_of(student, class_seed):
    """The seed that a teacher's gives to one student."""
    digest = hashlib.sha256(f"{class_seed} {student}".encode()).digest()
    return int.from_bytes(digest[:8], "big") % 9000 + 1000


def planted(exercise, seed):
    """The exercise's lines with the mistake of that seed, under the lines for seed and witness."""
    plant = exercise.plants[seed % len(exercise.plants)]
    code = "\n".join(exercise.region.code).replace(plant["find"], plant["replace"]).split("\n")
    indent = re.match(r"\s*", exercise.region.begin)[0]
    return [f"{indent}// seed {seed}", f"{indent}// witness:", *code]


def seed_in(code):
    """The seed that the lines name; None where that line is gone."""
    return next((int(match[1]) for match in map(SEED.match, code) if match), None)


def stub_of(exercise, code=(), seed=0):
    """What a workbook has before anything is written: for a hunt, by the seed of the lines, or by the
    given one."""
    if not exercise.plants:
        return exercise.region.stub
    named = seed_in(code)
    return planted(exercise, seed if named is None else named)
