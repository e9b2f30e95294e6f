local heard = 0
local ring = {}
for j = 1, 100 do ring[j] = function() heard = heard + 1 end end

function bench()
  heard = 0
  local i = 0
  while i < 100 do
    for _, handler in ipairs(ring) do handler() end
    i = i + 1
  end
  return heard
end
