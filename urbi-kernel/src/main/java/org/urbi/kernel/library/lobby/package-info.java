/** The lobby of a connection and what is sent through it (manual, "Lobby", "Channel", "Logger"). */
@NullMarked
package org.urbi.kernel.library.lobby;

import org.jspecify.annotations.NullMarked;
