local function exchange(list, i, j)
  local old = list[i]
  list[i] = list[j]
  list[j] = old
end

local function permute(list, n, state)
  if n == 0 then
    state.count = state.count + 1
    state.sum = (state.sum * 31 + list[1] * 7 + list[7]) % 65521
  else
    permute(list, n - 1, state)
    for i = n - 1, 0, -1 do
      exchange(list, n, i + 1)
      permute(list, n - 1, state)
      exchange(list, n, i + 1)
    end
  end
end

function bench()
  local list = {1, 2, 3, 4, 5, 6, 7}
  local state = {count = 0, sum = 0}
  permute(list, 6, state)
  return state.sum + state.count
end
