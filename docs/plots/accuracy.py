#!/usr/bin/env python3
"""Draws docs/plots/accuracy.svg from docs/studies/accuracy.csv, with gnuplot, and prints the settings
that are on each scene's frontier: those that no other setting beats in both time and error."""

import csv
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SCENES = {"cover": "cover: matte, metal, glass under a sky", "lamps": "lamps: the spires of chapter 11",
          "glass": "glass: balls, every other one hollow"}
# Color and point type; settings that share both share a name in the key.
STYLES = {
    "independent": ("#555555", 7, "independent"),
    "jittered": ("#0072b2", 7, "jittered"),
    "Sobol": ("#d55e00", 7, "Sobol"),
    "jittered in batches": ("#0072b2", 9, "jittered in batches"),
    "Sobol in twin halves": ("#d55e00", 9, "Sobol in twin halves"),
    "depth 2": ("#009e73", 7, "fewer bounces, ends in the sky"),
    "depth 4": ("#009e73", 7, "fewer bounces, ends in the sky"),
    "depth 8": ("#009e73", 7, "fewer bounces, ends in the sky"),
    "depth 16": ("#009e73", 7, "fewer bounces, ends in the sky"),
    "depth 8, black": ("#009e73", 5, "8 bounces, ends in black"),
    "roulette from 4": ("#009e73", 9, "roulette from 4 bounces"),
    "Schlick": ("#cc79a7", 7, "Schlick"),
    "t > 0.001": ("#56b4e9", 7, "t > 0.001"),
    "t > 0.001, scene / 1000": ("#56b4e9", 5, "t > 0.001, scene / 1000"),
    "lamps by chance": ("#cc79a7", 5, "lamps by chance"),
    "list of spheres": ("#e69f00", 7, "list of spheres"),
    "every effect compiled in": ("#e69f00", 5, "every effect compiled in"),
}


def frontier(rows):
    """The rows, by time, whose error is smaller than that of all rows before by 3 % or more: a smaller
    difference is chance."""
    best = []
    for row in sorted(rows, key=lambda r: (float(r["cost"]), float(r["error"]))):
        if not best or float(row["error"]) < 0.97 * float(best[-1]["error"]):
            best.append(row)
    return best


def panel(scene, rows, with_key):
    blocks, curves = [], []
    names = {}
    for row in rows:
        color, point, name = STYLES[row["variant"]]
        small = row["precision"] == "float"
        names.setdefault((color, point, name, small), []).append(f"{row['cost']} {row['error']}")
    edge = [f"{row['cost']} {row['error']}" for row in frontier(rows)]
    blocks.append(f"${scene}edge << END\n" + "\n".join(edge) + "\nEND\n")
    curves.append(f"${scene}edge with lines lw 6 lc rgb '#d9d9d9' title 'frontier'")
    for number, ((color, point, name, small), points) in enumerate(names.items()):
        blocks.append(f"${scene}{number} << END\n" + "\n".join(points) + "\nEND\n")
        title = "notitle" if small else f"title '{name}'"
        curves.append(f"${scene}{number} with points pt {point - 1 if small else point} ps 0.7 lc rgb '{color}' {title}")
    curves.append("NaN with points pt 6 ps 0.7 lc rgb '#000000' title 'hollow: float'")
    return ("".join(blocks) + f"set title '{SCENES[scene]}'\n" + ("" if with_key else "un") + "set key\n"
            + "plot " + ", ".join(curves) + "\n")


def main():
    with open(ROOT / "docs/studies/accuracy.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    script = """set terminal svg size 960,1500 font 'Helvetica,Arial,sans-serif,13' background '#ffffff'
set output 'docs/plots/accuracy.svg'
set border 3 lc rgb '#9a9a9a'
set grid lc rgb '#e4e4e4' lt 1
set tics nomirror scale 0.5
set logscale xy
set xrange [0.7:5000]
set yrange [0.007:0.5]
set format xy '%g'
set xlabel 'time of a picture of 64 x 36 pixels / ms'
set ylabel 'RMSE in a pixel'
set key outside right top Left reverse samplen 1 spacing 1.2
set multiplot layout 3,1 margins 0.08,0.72,0.05,0.96 spacing 0.09
"""
    for number, scene in enumerate(SCENES):
        here = [row for row in rows if row["study"] == scene]
        script += panel(scene, here, number == 0)
        print(f"{scene}:")
        best = frontier(here)
        for row in best:
            print(f"  {float(row['cost']):9.3g} ms {float(row['error']):.3g}  {row['variant']}, samples: {row['x']}, {row['precision']}")
        left = sorted({row["variant"] for row in here} - {row["variant"] for row in best})
        print("  never:", "; ".join(left))
    subprocess.run(["gnuplot"], input=script, text=True, check=True, cwd=ROOT)


if __name__ == "__main__":
    main()
