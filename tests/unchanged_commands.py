"""The commands whose outputs `unchanged.py` compares, by the name of what they say."""

from itertools import product

Commands = dict[str, str]

FEW = "--rollouts 6 --horizon 2"
STUDY = "learn --outcomes bank.parquet --seeds 2"
HELPED = ("record", "compare", "scenes", "sample", "learn", "render", "view")

FIRST: Commands = {
    "record/doorway": "record --scene doorway --rollouts 12 --out record",
    "scenes/toml": "scenes doorway --seed 3 --pattern group_blocking",
    "sample/bank": "sample --scenes 30 --rollouts 20 --out bank.parquet",
}
"""What the later commands need; the first of all compiles the engine."""

WRITING: Commands = {
    "record/number": f"record --scene intersection --number 11 --out record/number {FEW}",
    "record/helbing": f"record --scene open --model helbing-molnar --out record/helbing {FEW}",
    "record/walls": f"record --scene corridor --pattern group_blocking --out record/walls {FEW}",
    "record/seed": f"record --scene doorway --pattern mixed --seed 7 --out record/seed {FEW}",
    "record/noise": "record --scene open --pattern crossing --noise acceleration=0.2 --noise "
    f"goal=0 --no-mp4 --out record/noise {FEW}",
    "record/reference": "record --scene open --engine pysocialforce --rollouts 2 --horizon 1 "
    "--no-png --no-mp4 --out record/reference",
    "record/one": "record --scene doorway --rollouts 1 --no-mp4 --out record/one",
    "record/toml": f"record --scene inputs/mine.toml --out record/toml {FEW}",
    "record/tracks": f"record --scene inputs/tracks/obsmat.txt --frame 10383 --out record {FEW}",
    "record/placed": "record --scene inputs/tracks/obsmat.txt --frame 10443 --robot-start 3.5,4 "
    f"--robot-goal 9,5 --no-mp4 --out record/placed {FEW}",
    "compare/doorway": "compare --scene doorway forward slow_down --rollouts 8 --out compare",
    "compare/seed": f"compare --scene open stop turn_left --seed 1 --out compare/seed {FEW}",
    "compare/toml": "compare --scene inputs/mine.toml forward_left forward --no-mp4 --out "
    f"compare/toml {FEW}",
    "sample/chosen": "sample --scenes 5 --seed 4 --families open,corridor --patterns head_on,mixed "
    f"--model helbing-molnar --noise start=0 --out chosen.parquet {FEW}",
    "learn/pdf": f"{STUDY} --pairs 10,30 --figure learn/figure.pdf --out learn",
    "learn/svg": f"{STUDY} --pairs 5,20,5000 --figure learn/svg/figure.svg --out learn/svg",
    "learn/profile": f"{STUDY} --pairs 20 --teachers eu --profile cautious=0.9,0.9,4,0.6,0.7 "
    "--beta 8 --out learn/profile",
    "learn/one": f"{STUDY} --pairs 10,40 --learners eu --teachers tk --out learn/one",
    "learn/all": f"{STUDY} --pairs 30 --out learn/all --figure learn/all/figure.svg "
    "--learners eu,cpt,cpt-tied,cpt-reference,cpt-tied-reference",
    "learn/default": "learn --pairs 25 --seeds 1 --learners eu,cpt-tied --out learn/default",
}

SAYING: Commands = {
    "help/studio": "--help",
    "help/none": "",
    "help/version": "--version",
    **{f"help/{name}": f"{name} --help" for name in HELPED},
    "scenes/list": "scenes",
    "scenes/doorway": "scenes doorway",
    "scenes/number": "scenes intersection --pattern mixed --seed 2 --number 5",
    "scenes/tracks": "scenes inputs/tracks/obsmat.txt",
}

_WRONG = """
    fly
    record
    record --scene garden
    record --scene none.toml
    record --scene inputs/broken.toml
    record --scene inputs/contradicting.toml
    record --scene inputs/unknown.toml
    record --scene inputs/mine.toml --pattern mixed
    record --scene inputs/text.txt
    record --scene inputs/tracks/obsmat.txt --frame 1
    record --scene inputs/tracks/obsmat.txt --number 1
    record --scene inputs/tracks/obsmat.txt --robot-start here
    record --scene open --pattern bottleneck
    record --scene open --pattern waltz
    record --scene open --frame 3
    record --scene open --rollouts 0
    record --scene open --rollouts many
    record --scene open --horizon nan
    record --scene open --seed -1
    record --scene open --number -1
    record --scene open --model newton
    record --scene open --engine warp
    record --scene open --noise fog=1
    record --scene open --noise goal=x
    record --scene open --noise goal=-1
    record --scene open --rollouts 1 --out inputs/text.txt/deeper
    compare --scene doorway forward
    compare --scene doorway forward forward
    compare --scene doorway forward fly
    scenes garden
    scenes --pattern head_on
    sample --scenes 0
    sample --families garden
    sample --patterns waltz
    sample --families open --patterns bottleneck
    sample --scenes 1 --rollouts 1 --out inputs
    learn --outcomes none.parquet
    learn --outcomes inputs/text.txt
    learn --outcomes learn/learning.parquet
    learn --outcomes bank.parquet --learners oracle
    learn --outcomes bank.parquet --learners eu,eu
    learn --outcomes bank.parquet --teachers oracle
    learn --outcomes bank.parquet --profile odd
    learn --outcomes bank.parquet --profile odd=1,1,1,1,-1
    learn --outcomes bank.parquet --profile eu=1,1,1,1,1
    learn --outcomes bank.parquet --beta -1
    learn --outcomes bank.parquet --pairs few
    learn --outcomes bank.parquet --pairs 0
    learn --outcomes bank.parquet --seeds 0
    learn --outcomes bank.parquet --figure figure.png
    render none.rrd
    render inputs/text.txt
    render inputs/foreign.rrd
    render inputs/cut.rrd
    render record/doorway.rrd --png picture.jpg
    render record/doorway.rrd --png wrong.png --size big
    render record/doorway.rrd --png wrong.png --size 10x10
    render record/doorway.rrd --mp4 wrong.mp4 --size 641x361
    render record/doorway.rrd --png wrong.png --actions fly
    render record/doorway.rrd --png wrong.png --from 1
    render record/doorway.rrd --mp4 wrong.mp4 --from 3 --to 1
    render record/doorway.rrd --mp4 wrong.mp4 --from 90
    render record/doorway.rrd --mp4 wrong.mp4 --fps 0
    render record/doorway.rrd --gif wrong.gif --fps 1000
    render record/doorway.rrd --png wrong.png --theme blue
    render record/doorway.rrd --mp4 wrong.mp4 --codec vp8
    render compare/doorway-forward-slow_down.rrd --png wrong.png --actions forward
    render compare/doorway-forward-slow_down.rrd --mp4 wrong.mp4 --from 90
    render learn/learning.rrd --png wrong.png --actions forward
    render learn/learning.rrd --png wrong.png --from 11 --to 12
    view none.rrd
    view inputs/text.txt
"""

WRONG: Commands = {
    f"wrong/{number:02}": line.strip() for number, line in enumerate(_WRONG.strip().splitlines())
}
"""What ends in one line on standard error."""


def renderings(old: list[str]) -> Commands:
    """Pictures and films of every kind of recording, and of the old ones of these names."""
    kinds = {
        "scene": ("record/doorway.rrd", "--from 1.2 --to 2"),
        "comparison": ("compare/doorway-forward-slow_down.rrd", "--from 2 --to 3"),
        "study": ("learn/learning.rrd", "--from 10 --to 30"),
    }
    commands, few = {}, "--size 640x360 --fps 6"

    def files(name: str, *suffixes: str) -> str:
        return " ".join(f"--{suffix} {name}.{suffix}" for suffix in suffixes)

    for kind, (path, span) in kinds.items():
        for size, theme in product(("1280x720", "640x360"), ("light", "dark")):
            name = f"render/{kind}-{size}-{theme}"
            three = files(name, "png", "mp4", "gif")
            commands[name] = f"render {path} {three} --size {size} --theme {theme} --fps 5 {span}"
        name = f"render/{kind}-av1"
        commands[name] = f"render {path} {files(name, 'mp4')} {few} --codec av1 {span}"
        commands[f"render/{kind}-still"] = f"render {path} {files(f'render/{kind}-still', 'png')}"
        name = f"render/{kind}-all"
        commands[name] = f"render {path} {files(name, 'gif')} --size 640x360 --fps 2"
    name, actions = "render/scene-actions", "--actions stop,forward"
    commands[name] = f"render {kinds['scene'][0]} {files(name, 'png', 'mp4')} {few} {actions}"
    name = "render/study-from"
    commands[name] = f"render {kinds['study'][0]} {files(name, 'png')} --from 20"
    for each in old:
        name = f"render/{each}"
        commands[name] = f"render inputs/{each}.rrd {files(name, 'png', 'mp4', 'gif')} {few}"
    commands["render/beside"] = "render inputs/beside.rrd --fps 3"
    return commands
