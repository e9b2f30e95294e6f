local sleepers = {}

function bench()
  return 0
end

function putToBed()
  for i = 1, 100000 do
    local job = coroutine.create(function() coroutine.yield(3600) end)
    coroutine.resume(job)
    sleepers[i] = job
  end
  return #sleepers
end
