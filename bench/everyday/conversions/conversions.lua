function bench()
  local texts = {"12.5", "7", "-3.25", "1e3", "0.125"}
  local sum = 0
  local size = 0
  for i = 0, 199 do
    local x = tonumber(texts[i % 5 + 1])
    assert(type(x) == "number")
    sum = sum + x
    size = size + #string.format("%.2f", x)
    size = size + #tostring(i * 7)
  end
  return sum * 8 + size
end
