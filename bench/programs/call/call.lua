local Counter = {}
Counter.__index = Counter
function Counter:same(n) return n end

local counter = setmetatable({}, Counter)

function bench()
  local c = counter
  local last = 0
  for i = 0, 999999 do last = c:same(i) end
  return last
end
