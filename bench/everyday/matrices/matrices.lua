local function make_matrix(n, seed)
  local rows = {}
  for i = 0, n - 1 do
    local row = {}
    for j = 0, n - 1 do row[#row + 1] = (seed * i + 3 * j) % 17 end
    rows[#rows + 1] = row
  end
  return rows
end

local function multiply(a, b)
  local n = #a
  local rows = {}
  for i = 1, n do
    local row = {}
    for j = 1, n do
      local sum = 0
      for k = 1, n do sum = sum + a[i][k] * b[k][j] end
      row[#row + 1] = sum
    end
    rows[#rows + 1] = row
  end
  return rows
end

function bench()
  local c = multiply(make_matrix(25, 5), make_matrix(25, 7))
  local trace = 0
  for i = 1, 25 do trace = trace + c[i][i] * i - c[1][i] end
  return trace
end
