local numbers = {}
local seed = 42
for i = 1, 1000 do
  seed = (seed * 1309 + 13849) % 65536
  numbers[i] = seed
end

local function map(list, f)
  local result = {}
  for i, e in ipairs(list) do result[i] = f(e) end
  return result
end

local function filter(list, f)
  local result = {}
  for _, e in ipairs(list) do
    if f(e) then result[#result + 1] = e end
  end
  return result
end

local function fold(list, f, acc)
  for _, e in ipairs(list) do acc = f(acc, e) end
  return acc
end

local function sorted(list, f)
  local copy = {}
  for i, e in ipairs(list) do copy[i] = e end
  table.sort(copy, f)
  return copy
end

function bench()
  local halves = map(numbers, function(x) return (x - x % 2) / 2 end)
  local some = filter(halves, function(x) return x % 3 ~= 0 end)
  local in_order = sorted(some)
  local down = sorted(some, function(a, b) return a > b end)
  local total = fold(some, function(acc, x) return acc + x end, 0)
  local first = 0
  for i = 1, 10 do first = first + in_order[i] * i + down[i] end
  return first + total + #some
end
