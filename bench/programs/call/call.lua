local Counter = {}
Counter.__index = Counter
function Counter:same(n) return n end

local counter = setmetatable({}, Counter)

function bench()
  local c = counter
  local sum = 0
  for i = 0, 999999 do sum = sum + c:same(i) end
  return sum
end
