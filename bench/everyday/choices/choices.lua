local function by_number(n)
  if n == 0 then return 3
  elseif n == 1 then return 1
  elseif n == 2 then return 4
  elseif n == 3 then return 1
  elseif n == 4 then return 5
  elseif n == 5 then return 9
  else return 2 end
end

local function by_name(name)
  if name == "north" then return 1
  elseif name == "east" then return 2
  elseif name == "south" then return 3
  elseif name == "west" then return 4
  else return 0 end
end

local function area(shape)
  if #shape == 2 and shape[1] == "square" then return shape[2] * shape[2]
  elseif #shape == 3 and shape[1] == "rectangle" then return shape[2] * shape[3]
  elseif #shape == 3 and shape[1] == "triangle" then return shape[2] * shape[3] / 2
  else return 0 end
end

function bench()
  local names = {"north", "up", "south", "west", "east"}
  local shapes = {{"square", 3}, {"triangle", 4, 6}, {"rectangle", 2, 5}, {"point"}}
  local sum = 0
  for i = 0, 999 do
    sum = sum + by_number(i % 8)
    sum = sum + by_name(names[i % 5 + 1])
    sum = sum + area(shapes[i % 4 + 1])
  end
  return sum
end
