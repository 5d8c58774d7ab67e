"""The commands of ./course."""

import argparse
import difflib
import json
import os
import subprocess
import sys
import time
from pathlib import Path

from . import bubblewrap, check, class_report, engine as engines, exercises as catalog, formulas, grade
from . import headers, hunt, report, submission, verify, view as viewer, witness, workbook
from .errors import CHECK_FAILED, DONE, WRONG_INPUT, CourseError, MachineError
from .own import overlay, read_own

WORKBOOK = catalog.ROOT / "workbook"


def _print_json(value):
    print(json.dumps(value, indent=1))


def _chosen(options):
    return catalog.select(catalog.load(which=options.which), options.which)


def _chosen_one(options):
    return catalog.select_one(catalog.load(which=options.which), options.which)


def _engine(options, exercises):
    """What checks these exercises."""
    engine = engines.Engine()
    if options.seconds:
        engine.limits.seconds = engine.limits.cpu_seconds = options.seconds
    engine.limits.memory_bytes = options.memory << 30
    engine.build_limits.memory_bytes = options.memory << 30
    if options.build:
        engine.build = Path(options.build).resolve()
        for program in engine.programs_for(exercises):
            if not program.exists():
                raise CourseError(f"{program}: is not there. Build it, or leave out --build.")
        return engine
    engines.ensure_programs(engine, engine.programs_for(exercises))
    return engine


def _seed(options, exercises):
    """Of what is hunted."""
    if options.student and options.seed is None:
        raise CourseError("--student wants --seed too, which your teacher tells.")
    if options.seed is None:
        return workbook.seed_of(options.workbook, exercises)
    return hunt.seed_of(options.student, options.seed) if options.student else options.seed


def start(options):
    exercises = catalog.load()
    made = workbook.start(options.workbook, exercises, _seed(options, exercises))
    if options.json:
        _print_json({"made": made})
        return DONE
    for file in made:
        print(f"made {os.path.relpath(options.workbook / file)}")
    print("Nothing to make: every file is there." if not made else
          "Begin with `./course list`, then `./course show 1.1`.")
    return DONE


def list_all(options):
    """With a workbook, how far each exercise is."""
    rows = []
    for exercise in _chosen(options):
        state = (workbook.state_of(options.workbook, exercise) if options.workbook.is_dir()
                 else "no workbook")
        rows.append({"exercise": exercise.number, "title": exercise.title, "file": exercise.file,
                     "chapter": exercise.chapter, "state": state})
    if options.json:
        _print_json({"exercises": rows})
        return DONE
    chapter = None
    for row in rows:
        if row["chapter"] != chapter:
            chapter = row["chapter"]
            print(chapter)
        print(f"  {row['exercise']:<4} {row['state']:<17} {row['title']}")
    passed = sum(row["state"] == check.PASSED for row in rows)
    print(f"{passed} of {len(rows)} passed")
    return DONE


def _given_ray(options, engine, exercise):
    if options.ray is None:
        return None
    ray, _ = witness.place_in(engine, exercise, options.ray, f"--ray {options.ray}")
    return [ray]


def _check_once(options, engine, chosen):
    results = []
    for exercise in chosen:
        rays = _given_ray(options, engine, exercise)
        store = None if rays else engines.STORE / "pictures"
        results.append(check.check(engine, exercise, options.workbook, rays, store))
        if not options.json:
            print(report.as_text(results[-1]), flush=True)
    if options.ray is None:
        workbook.remember(options.workbook, results)
    if options.json:
        _print_json({"results": [report.as_json(result) for result in results]})
    elif len(results) > 1:
        print(report.summary(results))
    return DONE if all(result.state in check.FINE for result in results) else CHECK_FAILED


def _times(options, chosen):
    paths = [options.workbook / file for file in workbook.files_of(chosen)]
    return [path.stat().st_mtime_ns if path.exists() else 0 for path in paths]


def check_some(options):
    workbook.require(options.workbook)
    chosen = _chosen(options)
    engine = _engine(options, chosen)
    code = _check_once(options, engine, chosen)
    while options.watch:
        before = _times(options, chosen)
        print("-- waiting for a change; Ctrl-C ends", flush=True)
        while _times(options, chosen) == before:
            time.sleep(0.3)
        chosen = _chosen(options)
        engine.states.clear()
        code = _check_once(options, engine, chosen)
    return code


def view(options):
    exercise = _chosen_one(options)
    engine = _engine(options, [exercise])
    rays = _given_ray(options, engine, exercise)
    if rays:
        words = viewer.given_ray(exercise, rays[0])
        both = viewer.both_walks(engine, exercise, viewer.checkpoint_of_rays(exercise), rays[0],
                                 options.workbook)
        print(_what_is_seen(both), flush=True)
        return viewer.open_visualizer(engine, both or words, options.screenshot)
    workbook.require(options.workbook)
    for is_shown in (False, True):  # the picture of what is wrong only where no ray can be shown
        result = check.check(engine, exercise, options.workbook, None, engines.STORE / "pictures",
                             is_shown)
        if result.state in check.FINE or viewer.wrong_ray(result):
            break
    print(report.as_text(result), flush=True)
    words = viewer.wrong_ray(result)
    if words is None:
        print(viewer.nothing_to_see(exercise))
        return DONE if result.state in check.FINE else CHECK_FAILED
    both = viewer.both_wrong_walks(engine, result, options.workbook)
    print(_what_is_seen(both), flush=True)
    return viewer.open_visualizer(engine, both or words, options.screenshot)


def _what_is_seen(both):
    if both is None:
        return ("What you see is the right walk, by the project's own lines. No other walk of yours "
                "was found.")
    return ("First stands your walk, as your lines made it round by round; then the right one. It opens "
            "where they part, and the key D jumps there.")


def run_program(options):
    """A program of the project with the person's lines of one exercise, and the project's own for all
    others."""
    exercise = _chosen_one(options)
    workbook.require(options.workbook)
    if not exercise.is_shader:
        raise CourseError(f"{exercise.number} is in C++, and a program would have to be built with it. "
                          f"`./course check {exercise.number} --ray=...` tries numbers of yours.")
    build = Path(options.build or engines.BUILD) / "chapters"
    programs = sorted(build.glob(f"{options.program}*/{options.program}*"))
    program = next((path for path in programs if path.name == path.parent.name), None)
    if program is None:
        raise CourseError(f"{options.program}: is not built. `./run.sh {options.program} --help` builds it.")
    with overlay(exercise, read_own(exercise, options.workbook)) as folder:
        environment = {**os.environ, "RAYSTEPS_SHADERS": str(folder / "shaders")}
        return subprocess.run([program, *options.arguments], env=environment, check=False).returncode


def hint(options):
    exercise = _chosen_one(options)
    level = options.level
    if options.json:
        _print_json({"exercise": exercise.number, "hints": exercise.hints[:level]})
        return DONE
    for number, text in enumerate(exercise.hints[:level], 1):
        print(f"Hint {number} of {len(exercise.hints)}: {text}")
    if level < len(exercise.hints):
        print(f"`./course hint {exercise.number} --level {level + 1}` says more.")
    return DONE


def show(options):
    exercise = _chosen_one(options)
    path = options.workbook / exercise.file
    if options.json:
        _print_json({"exercise": exercise.number, "title": exercise.title, "task": exercise.task,
                     "file": str(path), "formulas": exercise.formulas, "source": exercise.source,
                     "chapter": exercise.chapter, "includes": headers.of(exercise),
                     "at_hand": headers.functions(exercise),
                     "checkpoints": [checkpoint.name for checkpoint in exercise.checkpoints]})
        return DONE
    print(f"{exercise.number} {exercise.title}\n\n{exercise.task}\n")
    for formula in exercise.formulas:
        print(f"  {formulas.plain(formula)}")
    line = ""
    code = workbook.code_of(options.workbook, exercise)
    if code is not None:
        line = f":{_line_of(path, exercise)}"
    print(f"\nfile         {os.path.relpath(path)}{line}")
    for place, words in enumerate(headers.as_text(exercise)):
        print(f"{'' if place else 'headers':<12} {words}")
    for place, call in enumerate(headers.functions(exercise)):
        print(f"{'' if place else 'at hand':<12} {call}")
    print(f"lesson       chapters/{exercise.chapter}/README.md")
    print(f"source       {exercise.source}")
    if exercise.checkpoints:
        print(f"checkpoints  {', '.join(checkpoint.name for checkpoint in exercise.checkpoints)}")
    print(f"check        ./course check {exercise.number}")
    print(f"hint         ./course hint {exercise.number}")
    return DONE


def _line_of(path, exercise):
    from . import marks
    return marks.regions(marks.text_of(path), path)[exercise.number].first


def reset(options):
    exercise = _chosen_one(options)
    workbook.require(options.workbook)
    kept = workbook.reset(options.workbook, exercise)
    if options.json:
        _print_json({"reset": exercise.number, "kept": str(kept) if kept else None})
    else:
        print(f"{exercise.number} is a stub again; the file as it was is {os.path.relpath(kept)}"
              if kept else f"{exercise.number} is a stub.")
    return DONE


def diff(options):
    exercise = _chosen_one(options)
    workbook.require(options.workbook)
    state = workbook.state_of(options.workbook, exercise)
    if state != check.PASSED and not options.give_up:
        raise CourseError(f"{exercise.number}: {state}. The solution is shown when its check has "
                          f"passed, or with --give-up. `./course hint {exercise.number}` helps too.")
    own = workbook.code_of(options.workbook, exercise) or []
    lines = list(difflib.unified_diff(own, exercise.region.code, "yours", "the solution",
                                      lineterm=""))
    if options.json:
        _print_json({"exercise": exercise.number, "yours": own, "solution": exercise.region.code})
    else:
        print("\n".join(lines) if lines else "Yours is the solution, line by line.")
    return DONE


def pack(options):
    workbook.require(options.workbook)
    name = options.student
    if not name or not all(letter.isalnum() or letter in "-_." for letter in name) or name[0] in ".-":
        raise CourseError(f"--student {name}: take letters, digits, - and _ for the name.")
    archive = Path(options.out) / f"{name}.zip"
    files = submission.pack(options.workbook, catalog.load(), archive)
    if options.json:
        _print_json({"archive": str(archive), "files": files})
    else:
        print(f"wrote {archive}, with {len(files)} files")
    return DONE


def _grade_submissions(options):
    chosen = catalog.select(catalog.load(which=options.only), options.only)
    if options.merge:
        return grade.merge(options.merge)
    if options.one and not Path(options.one).exists():
        raise CourseError(f"{options.one}: there is no such submission.")
    if not options.without_sandbox:
        bubblewrap.require()
    engine = _engine(options, chosen)
    engine.is_enclosed = not options.without_sandbox
    paths = [Path(options.one)] if options.one else submission.list_submissions(Path(options.folder))
    grades = []
    for path in paths:
        grades.append(grade.grade_one(engine, path, chosen, options.seed, options.student))
        if sys.stderr.isatty():
            print(f"{grades[-1]['submission']}: {grades[-1]['score']} of {grades[-1]['of']}",
                  file=sys.stderr)
    return grades


def grade_all(options):
    if sum(bool(given) for given in (options.folder, options.one, options.merge)) != 1:
        raise CourseError("grade: name a folder of submissions, or one with --one, or results with "
                          "--merge.")
    if options.folder and not Path(options.folder).is_dir():
        raise CourseError(f"{options.folder}: there is no such folder.")
    if options.gradescope and not options.one:
        raise CourseError("--gradescope: its format is for one submission. Name it with --one.")
    if options.student and not options.one:
        raise CourseError("--student: names one submission. Name its file with --one.")
    if options.jobs_file:
        if not options.folder:
            raise CourseError("--jobs-file wants a folder of submissions.")
        settings = ["--memory", options.memory]
        settings += ["--seconds", options.seconds] if options.seconds else []
        settings += ["--build", Path(options.build).resolve()] if options.build else []
        more = ["--only", options.only] if options.only else []
        more += ["--without-sandbox"] if options.without_sandbox else []
        more += ["--seed", str(options.seed)] if options.seed is not None else []
        count = grade.write_jobs(options.jobs_file, Path(options.folder), Path(options.results),
                                 settings, more)
        print(f"wrote {options.jobs_file}, with {count} commands; their results go to "
              f"{options.results}")
        return DONE
    grades = _grade_submissions(options)
    if options.csv:
        grade.write_csv(options.csv, grades)
    if options.json:
        grade.write_json(options.json, grades)
    if options.gradescope:
        class_report.write_gradescope(options.gradescope, grades[0])
    faults = class_report.faults(grades)
    if options.faults:
        class_report.write_faults(options.faults, faults)
    for one in grades:
        print(class_report.row(one))
    if len(grades) > 1 and faults:
        print("\n" + class_report.faults_text(faults))
    if any(grade.UNKNOWN in one["exercises"].values() for one in grades):
        raise MachineError(f"some exercises are `{grade.UNKNOWN}`, since this machine could not check them "
                           "(--json says why). Grade them again.")
    return DONE


def verify_all(options):
    chosen = catalog.select(catalog.load(with_answers=True, which=options.which), options.which)
    engine = _engine(options, chosen)

    def say(finding):
        if not options.json and (options.verbose or not finding.is_right):
            word = "ok   " if finding.is_right else "WRONG"
            print(f"{word} {finding.number} {finding.kind}: {finding.text}"
                  f"{' -- ' + finding.detail if finding.detail else ''}", flush=True)

    with engines.with_companions(engine) as staying:
        findings = verify.verify(staying, chosen, engines.STORE / "verify", options.workers, say)
    wrong = [finding for finding in findings if not finding.is_right]
    caught = [finding for finding in findings
              if finding.kind in ("mutation", "wrong") and finding.is_right]
    if options.json:
        _print_json({"findings": [vars(finding) for finding in findings], "wrong": len(wrong)})
    else:
        print(f"{len(chosen)} exercises, {len(caught)} mistakes caught, {len(findings)} trials, "
              f"{len(wrong)} wrong")
    return CHECK_FAILED if wrong else DONE


def _parser():
    parser = argparse.ArgumentParser(prog="./course", description="The coursework of Raysteps.")
    parser.add_argument("--workbook", type=Path, default=WORKBOOK, help="the folder of your files")
    parser.add_argument("--build", help="a build folder that has the programs course_shaders and "
                                        "course_builders; else build/default, built as needed")
    parser.add_argument("--memory", type=int, default=8, metavar="GIB",
                        help="what a checked program may reserve, in GiB; 0: all there is (8)")
    parser.add_argument("--seconds", type=int, metavar="S",
                        help="what a checked program may take, of the clock and of processors (60 and 4)")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")

    def add(name, run, text, **which):
        command = commands.add_parser(name, help=text, description=text)
        command.set_defaults(run=run)
        if which:
            command.add_argument("which", **which)
        if name not in ("grade", "view", "run"):
            command.add_argument("--json", action="store_true", help="print JSON")
        return command

    some = {"nargs": "?", "metavar": "CHAPTER|EXERCISE", "help": "as 04 or 4.2; else all"}
    one = {"metavar": "EXERCISE", "help": "as 4.2"}
    command = add("start", start, "make the workbook; what is there stays")
    command.add_argument("--seed", type=int, help="chooses what is to be hunted; else by chance")
    command.add_argument("--student", metavar="NAME", help="with a seed that a teacher gave to all: yours is another")
    add("list", list_all, "the exercises, and how far you are", **some)
    command = add("check", check_some, "check exercises", **some)
    command.add_argument("--watch", action="store_true", help="check again at each change")
    command.add_argument("--ray", help="only this ray: ox,oy,oz,dx,dy,dz[,t_min,t_max], or `pixel 33,11`")
    command = add("view", view, "the visualizer at the first wrong ray of an exercise", **one)
    command.add_argument("--ray", help="this ray instead: ox,oy,oz,dx,dy,dz[,t_min,t_max], or `pixel 33,11`")
    command.add_argument("--screenshot", metavar="FILE", help="a picture instead of a window")
    command = add("run", run_program, "a program with your lines of one exercise", **one)
    command.add_argument("program", metavar="PROGRAM", help="as 03 or hard_cases")
    command.add_argument("arguments", nargs=argparse.REMAINDER, help="its own options")
    command = add("hint", hint, "a hint, in three levels", **one)
    command.add_argument("--level", type=int, choices=(1, 2, 3), default=1)
    add("show", show, "task, file, formulas and source of an exercise", **one)
    add("reset", reset, "put the stub back", **one)
    command = add("diff", diff, "your lines against the solution", **one)
    command.add_argument("--give-up", action="store_true", help="before yours has passed")
    command = add("pack", pack, "a zip file of your workbook, to hand in")
    command.add_argument("--student", required=True, metavar="NAME", help="the file is NAME.zip")
    command.add_argument("--out", default=".", help="the folder for it")
    command = add("grade", grade_all, "grade submissions: folders, zip and tar files",
                  nargs="?")
    command._actions[-1].dest = "folder"
    command.add_argument("--csv", help="a file for the table")
    command.add_argument("--json", help="a file for everything that was found")
    command.add_argument("--only", metavar="CHAPTER|EXERCISE", help="as 04 or 4.2; else all")
    command.add_argument("--one", metavar="SUBMISSION", help="grade this one")
    command.add_argument("--student", metavar="NAME", help="with --one: whose it is, where its file has another name")
    command.add_argument("--seed", type=int, help="the one that students gave to `start --student`: who has "
                                                  "hunted another mistake fails")
    command.add_argument("--jobs-file", help="write a command a submission, and grade nothing")
    command.add_argument("--results", default="results", help="the folder for --jobs-file's results")
    command.add_argument("--merge", nargs="+", metavar="JSON", help="join results of --json")
    command.add_argument("--faults", metavar="CSV", help="a file for what the class fails, and how")
    command.add_argument("--gradescope", metavar="JSON", help="with --one: a file as Gradescope reads it, "
                                                              "results.json")
    command.add_argument("--without-sandbox", action="store_true",
                         help="where bubblewrap cannot run: what was handed in may do what you may")
    command = add("verify", verify_all, "the author's check of the exercises", **some)
    command.add_argument("--verbose", action="store_true", help="every trial, not only wrong ones")
    command.add_argument("--workers", type=int, default=min(4, os.cpu_count() or 1))
    return parser


def main(arguments):
    """The exit code: 0 done, 1 a check failed, 2 wrong usage or input, 3 the machine lacks
    something."""
    options = _parser().parse_args(arguments)
    options.workbook = options.workbook.resolve()
    try:
        return options.run(options)
    except CourseError as error:
        print(f"course: {error}", file=sys.stderr)
        return error.code
    except OSError as error:
        print(f"course: {error.filename or ''}: {error.strerror}. Check the name and the disk.",
              file=sys.stderr)
        return WRONG_INPUT
    except KeyboardInterrupt:
        return 130
    except BrokenPipeError:
        return DONE
