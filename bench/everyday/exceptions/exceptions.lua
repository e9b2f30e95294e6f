local Trouble = {}
Trouble.__index = Trouble

local function check(depth, n)
  if depth == 0 then
    if n % 3 == 0 then error(setmetatable({code = n}, Trouble)) end
    return n
  else
    return check(depth - 1, n) + 1
  end
end

function bench()
  local sum = 0
  local tidied = 0
  for n = 0, 999 do
    local ok, result = pcall(check, 5, n)
    tidied = tidied + 1
    if ok then
      sum = sum + result
    elseif getmetatable(result) == Trouble then
      sum = sum - result.code
    else
      error(result)
    end
  end
  return sum + tidied
end
