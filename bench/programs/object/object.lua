local Point = {}
Point.__index = Point
function Point.new(n)
  local self = setmetatable({}, Point)
  self.x = n
  return self
end

function bench()
  local last
  for i = 0, 99999 do last = Point.new(i) end
  return last.x
end
