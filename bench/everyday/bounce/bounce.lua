local Random = {}
Random.__index = Random
function Random:next()
  self.seed = (self.seed * 1309 + 13849) % 65536
  return self.seed
end

local Ball = {}
Ball.__index = Ball
function Ball.new(random)
  return setmetatable({
    x = random:next() % 500,
    y = random:next() % 500,
    x_speed = random:next() % 300 - 150,
    y_speed = random:next() % 300 - 150
  }, Ball)
end

function Ball:step()
  local bounced = false
  self.x = self.x + self.x_speed
  self.y = self.y + self.y_speed
  if self.x > 500 then self.x = 500; self.x_speed = 0 - math.abs(self.x_speed); bounced = true end
  if self.x < 0 then self.x = 0; self.x_speed = math.abs(self.x_speed); bounced = true end
  if self.y > 500 then self.y = 500; self.y_speed = 0 - math.abs(self.y_speed); bounced = true end
  if self.y < 0 then self.y = 0; self.y_speed = math.abs(self.y_speed); bounced = true end
  return bounced
end

function bench()
  local random = setmetatable({seed = 74755}, Random)
  local balls = {}
  for i = 1, 100 do balls[#balls + 1] = Ball.new(random) end
  local bounces = 0
  for i = 1, 50 do
    for _, ball in ipairs(balls) do
      if ball:step() then bounces = bounces + 1 end
    end
  end
  return bounces
end
