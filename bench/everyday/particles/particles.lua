local Point = {}
Point.__index = Point
function Point.new(x, y) return setmetatable({x = x, y = y}, Point) end
function Point:add(other)
  self.x = self.x + other.x
  self.y = self.y + other.y
end

local Particle = {}
Particle.__index = Particle
function Particle.new(x, y, vx, vy)
  return setmetatable({place = Point.new(x, y), speed = Point.new(vx, vy)}, Particle)
end

function Particle:step()
  self.place:add(self.speed)
  if self:is_outside(self.place.x) then self.speed.x = 0 - self.speed.x end
  if self:is_outside(self.place.y) then self.speed.y = 0 - self.speed.y end
end

function Particle:is_outside(value) return value < 0 or value > 100 end

function bench()
  local particles = {}
  for i = 0, 49 do particles[#particles + 1] = Particle.new(i, 100 - i, i % 7 - 3, i % 5 - 2) end
  for i = 1, 40 do
    for _, particle in ipairs(particles) do particle:step() end
  end
  local sum = 0
  for _, particle in ipairs(particles) do
    sum = sum + particle.place.x * 3 + particle.place.y
  end
  return sum
end
