function bench()
  local sum = 0
  for row = 0, 59 do
    local ci = row / 30 - 1
    for column = 0, 59 do
      local cr = column / 30 - 1.5
      local zr = 0
      local zi = 0
      local n = 0
      while n < 50 and zr * zr + zi * zi < 4 do
        local next = zr * zr - zi * zi + cr
        zi = 2 * zr * zi + ci
        zr = next
        n = n + 1
      end
      sum = sum + n
    end
  end
  return sum
end
