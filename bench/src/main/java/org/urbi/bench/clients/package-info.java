/** Many console clients at a time, beside a bare echo. */
@NullMarked
package org.urbi.bench.clients;

import org.jspecify.annotations.NullMarked;
