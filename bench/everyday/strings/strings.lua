function bench()
  local text = ""
  for i = 0, 399 do text = text .. "word" .. i % 37 .. "," end
  local lines = {}
  for word in text:gmatch("[^,]+") do
    if #word == 6 and word:sub(5, 5) == "2" then
      lines[#lines + 1] = word:upper() .. "!"
    else
      lines[#lines + 1] = word:gsub("word", "W")
    end
  end
  local joined = table.concat(lines, " ")
  local vowels = 0
  for i = 1, #joined do
    if joined:sub(i, i) == "O" then vowels = vowels + 1 end
  end
  return #joined * 1000 + vowels
end
