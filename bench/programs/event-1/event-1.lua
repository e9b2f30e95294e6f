local heard = 0
local ring = {function() heard = heard + 1 end}

function bench()
  heard = 0
  local i = 0
  while i < 10000 do
    for _, handler in ipairs(ring) do handler() end
    i = i + 1
  end
  return heard
end
