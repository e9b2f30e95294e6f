/** How fast UObjects in another process are, beside a bare echo over the same loopback. */
package org.urbi.bench.remote;
