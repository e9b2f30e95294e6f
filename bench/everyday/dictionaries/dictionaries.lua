local text = {}
local seed = 42
for i = 1, 2000 do
  seed = (seed * 1309 + 13849) % 65536
  text[i] = "k" .. seed % 500
end

function bench()
  local counts = {}
  for _, word in ipairs(text) do
    if counts[word] then
      counts[word] = counts[word] + 1
    else
      counts[word] = 1
    end
  end
  local by_length = {}
  local size = 0
  for word in pairs(counts) do
    size = size + 1
    local length = #word
    if not by_length[length] then by_length[length] = 0 end
    by_length[length] = by_length[length] + counts[word]
  end
  local sum = 0
  for length in pairs(by_length) do sum = sum + length * by_length[length] end
  return sum * 1000 + size
end
