function bench()
  local list = {}
  for i = 0, 99999 do list[#list + 1] = i end
  return #list
end
