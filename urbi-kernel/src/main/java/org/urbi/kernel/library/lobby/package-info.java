/** The lobby of a connection and what is sent through it (manual, "Lobby", "Channel", "Logger"). */
package org.urbi.kernel.library.lobby;
