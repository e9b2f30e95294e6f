position = 0
speed = 1
goal = 100
turns = 0

function move()
  position = position + speed
  if position >= goal or position <= 0 then
    speed = 0 - speed
    turns = turns + 1
  end
end

function bench()
  position = 0
  speed = 1
  turns = 0
  for i = 1, 3000 do move() end
  return turns * 1000 + position
end
