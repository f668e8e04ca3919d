B=install/link_router_bench/bin/link_router_bench
C="receipt_delay_s=0.02 receipt_period_s=0.05"
for a in "repair_first_s=0.06 repair_backoff=1.6 $C" "repair_first_s=0.07 repair_backoff=1.3 $C" "repair_first_s=0.07 repair_backoff=1.5 receipt_delay_s=0.015 receipt_period_s=0.05 utilisation=0.45" ; do echo "== $a"; for v in "802.11e all" "all"; do nice $B 6 "only=$v" $a 2>/dev/null | tail -n +2| cut -c1-220; done;  done
