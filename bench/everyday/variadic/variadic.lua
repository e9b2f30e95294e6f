local function sum_of(...)
  local sum = 0
  for _, e in ipairs({...}) do sum = sum + e end
  return sum
end

function bench()
  local sum = 0
  for i = 0, 499 do
    sum = sum + sum_of(i, 1)
    sum = sum + sum_of(i, 2, 3, 4)
    sum = sum + sum_of()
  end
  return sum
end
