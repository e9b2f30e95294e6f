-- Runs a program of the benchmarks: driver.lua PROGRAM, then "FUNCTION TIMES" on standard input.
dofile(arg[1])
print("ready")
io.stdout:flush()
for line in io.lines() do
  local name, times = line:match("(%a+) (%d+)")
  local func = _G[name]
  local result
  for turn = 1, tonumber(times) do result = func() end
  print(string.format(type(result) == "number" and "%.6f" or "%s", result))
  io.stdout:flush()
end
