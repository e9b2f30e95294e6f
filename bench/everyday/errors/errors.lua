function bench()
  local list = {1, 2, 3}
  local object = {there = 1}
  local sum = 0
  for n = 0, 499 do
    local ok, value = pcall(function() return 0 + list[n % 6 + 1] end)
    sum = sum + (ok and value or 10)
    local found, other = pcall(function()
      sum = sum + object.there
      return 0 + object.nowhere
    end)
    sum = sum + (found and other or 100)
  end
  return sum
end
