"""Runs a program of the benchmarks: driver.py PROGRAM, then "FUNCTION TIMES" on standard input."""

import sys

program = {"__name__": "program"}
with open(sys.argv[1]) as source:
    exec(compile(source.read(), sys.argv[1], "exec"), program)
print("ready", flush=True)
for line in sys.stdin:
    name, times = line.split()
    function = program[name]
    result = None
    for turn in range(int(times)):
        result = function()
    print(result, flush=True)
