-- How long 100,000 coroutines that have been put to sleep take to run when their time has come.
function bench()
  local awake = 0
  local sleepers = {}
  local moment = os.clock()
  for i = 1, 100000 do
    local job = coroutine.create(function(deadline)
      coroutine.yield(deadline)
      awake = awake + 1
    end)
    coroutine.resume(job, moment)
    sleepers[i] = job
  end
  moment = os.clock()
  for i = 1, #sleepers do coroutine.resume(sleepers[i]) end
  assert(awake == #sleepers)
  return os.clock() - moment
end
