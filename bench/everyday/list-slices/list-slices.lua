local function tail(list)
  local rest = {}
  for i = 2, #list do rest[i - 1] = list[i] end
  return rest
end

local function concat(one, pivot, other)
  local all = {}
  for _, e in ipairs(one) do all[#all + 1] = e end
  all[#all + 1] = pivot
  for _, e in ipairs(other) do all[#all + 1] = e end
  return all
end

local function quick_sort(list)
  if #list <= 1 then return list end
  local pivot = list[1]
  local less, more = {}, {}
  for _, e in ipairs(tail(list)) do
    if e < pivot then less[#less + 1] = e else more[#more + 1] = e end
  end
  return concat(quick_sort(less), pivot, quick_sort(more))
end

local numbers = {}
local seed = 42
for i = 1, 400 do
  seed = (seed * 1309 + 13849) % 65536
  numbers[i] = seed
end

function bench()
  local sum = 0
  for _, e in ipairs(quick_sort(numbers)) do sum = (sum * 31 + e) % 65521 end
  return sum
end
