local function make_counter(step)
  local count = 0
  return function()
    count = count + step
    return count
  end
end

local function compose(f, g)
  return function(x) return f(g(x)) end
end

function bench()
  local counters = {}
  for i = 0, 19 do counters[#counters + 1] = make_counter(i) end
  local sum = 0
  for i = 1, 100 do
    for _, counter in ipairs(counters) do sum = sum + counter() end
  end
  local add_one = function(x) return x + 1 end
  local twice = function(x) return x * 2 end
  local both = compose(add_one, compose(twice, add_one))
  for i = 0, 1999 do sum = (sum + both(i)) % 65521 end
  return sum
end
