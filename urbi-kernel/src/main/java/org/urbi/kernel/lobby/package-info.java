/** The top level of a connection: its input, its output. */
package org.urbi.kernel.lobby;
