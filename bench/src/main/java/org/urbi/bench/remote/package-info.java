/** How fast UObjects in another process are, beside a bare echo over the same loopback. */
@NullMarked
package org.urbi.bench.remote;

import org.jspecify.annotations.NullMarked;
