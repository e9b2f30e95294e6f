function bench()
  local o = {}
  local size = 0
  for i = 0, 49151 do o["s" .. i] = i end
  for _ in pairs(o) do size = size + 1 end
  return size
end
