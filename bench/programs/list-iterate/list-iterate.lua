local list = {}
for i = 0, 99999 do list[#list + 1] = i end

function bench()
  local sum = 0
  for _, e in ipairs(list) do sum = sum + e end
  return sum
end
