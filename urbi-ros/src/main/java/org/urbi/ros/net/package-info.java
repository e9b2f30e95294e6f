/** Listening for connections. */
@NullMarked
package org.urbi.ros.net;

import org.jspecify.annotations.NullMarked;
