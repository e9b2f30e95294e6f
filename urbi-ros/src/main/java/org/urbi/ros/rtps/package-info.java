/**
 * A participant of RTPS 2.x (the wire protocol of DDS) in plain Java: it finds other participants
 * of its domain, tells them of its writers and readers, and exchanges samples with theirs, at best
 * effort or reliably. It knows nothing of ROS: a payload is bytes, a type is a name.
 *
 * <p>Everything a participant knows is guarded by one lock, that of its {@link
 * org.urbi.ros.rtps.Reactor}. Two threads work for it: one receives, one has the timers and sends
 * what has to be paced. Listeners are called by these two, without the lock, one at a time.
 */
@NullMarked
package org.urbi.ros.rtps;

import org.jspecify.annotations.NullMarked;
